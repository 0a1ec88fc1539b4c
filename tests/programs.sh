# Sourced by scripts that run all tests in few processes.

# programs_in FOLDER: the test programs of a build folder.
programs_in() { find "$1/tests" -name 'test_*' -type f -perm -u+x | sort; }

# What ctest runs besides their cases, whose names have no space behind the colon; checks on sources run no program,
# and instructions are counted in a build without a sanitizer.
besides=(-LE checks -E '^[a-z_]+:[^ ]|instruction counts')
