# Sourced by scripts that run all tests in few processes.
programs=(texunit raster factor scenes study hostile bench quality)  # tests/test_NAME of a build folder
# What ctest runs besides their cases, whose names have no space behind the colon; checks on sources run no program.
besides=(-LE checks -E '^[a-z]+:[^ ]')
