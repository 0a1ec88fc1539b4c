#include "study/report.hpp"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "report_sample.hpp"

using namespace twofold;

namespace {

std::string between(const std::string& text, const std::string& open, const std::string& close) {
    const std::size_t start = text.find(open) + open.size();
    return text.substr(start, text.find(close, start) - start);
}

nlohmann::json data_of(const std::string& html) {
    return nlohmann::json::parse(between(html, "id=\"data\">", "</script>"));
}

std::size_t count(const std::string& text, const std::string& what) {
    std::size_t n = 0;
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; ++at) ++n;
    return n;
}

ReportComparison comparison(const std::string& picture, const std::string& reference, double rms) {
    ReportComparison c{picture, reference, {}, {}};
    c.difference.pixels_compared = 100;
    c.difference.rms_steps = rms;
    return c;
}

Report titled(const std::string& title) {
    Report report;
    report.title = title;
    return report;
}

std::string source_of(const std::vector<unsigned char>& png) {
    Report report;
    report.pictures = {{"exact", png, ""}};
    return data_of(report_html(report))["pictures"][0]["src"].get<std::string>();
}

}  // namespace

TEST_CASE("a report of nothing is still a whole page") {
    const std::string html = report_html(Report{});
    CHECK(html.starts_with("<!doctype html>"));
    CHECK(html.ends_with("</html>\n"));
    CHECK(data_of(html)["pictures"].empty());
    CHECK(summary_sentence(Report{}) == "No picture was compared with the exact one.");
}

TEST_CASE("the page reaches for nothing outside itself", "[long]") {
    const std::string html = report_html(sample_report());
    CHECK(count(html, "src=\"http") == 0);
    CHECK(count(html, "<link") == 1);
    CHECK(count(html, "@import") == 0);
    CHECK(count(html, "default-src 'none'") == 1);
    CHECK(html.find("{{") == std::string::npos);
}

TEST_CASE("no text of the scene can break out of its place") {
    const std::string evil = "</script><script>alert(1)</script><!-- & \"quoted\" </title>";
    const std::string html = report_html(titled(evil));
    CHECK(count(html, "<script") == count(report_html(Report{}), "<script"));
    CHECK(count(html, "</title>") == 1);
    CHECK(data_of(html)["title"] == evil);
}

TEST_CASE("a text that looks like a marker of the template stays as it is") {
    const std::string html = report_html(titled("{{data}} {{style}}"));
    CHECK(data_of(html)["title"] == "{{data}} {{style}}");
    CHECK(html.find("<h1>{{data}} {{style}}</h1>") != std::string::npos);
}

TEST_CASE("a name that is not UTF-8 is shown with replacement characters") {
    const nlohmann::json data = data_of(report_html(titled("caf\xe9 m\xc3\xa9tal")));
    CHECK(data["title"] == "caf\xef\xbf\xbd m\xc3\xa9tal");
}

TEST_CASE("numbers that are not finite become null") {
    Report report;
    report.white = std::numeric_limits<double>::quiet_NaN();
    report.comparisons = {comparison("nv17", "exact", 0.0)};
    const nlohmann::json data = data_of(report_html(report));
    CHECK(data["white"].is_null());
    CHECK(data["comparisons"][0]["psnr"].is_null());
    CHECK(data["comparisons"][0]["first"].is_null());
}

TEST_CASE("pictures become base64 with the right padding") {
    CHECK(source_of({'M'}) == "data:image/png;base64,TQ==");
    CHECK(source_of({'M', 'a'}) == "data:image/png;base64,TWE=");
    CHECK(source_of({'M', 'a', 'n'}) == "data:image/png;base64,TWFu");
    CHECK(source_of({0xff, 0xfe, 0x00, 0x80}) == "data:image/png;base64,//4AgA==");
}

TEST_CASE("the histogram ends at the largest difference") {
    Report report;
    report.comparisons = {comparison("nv17", "exact", 1.0)};
    report.comparisons[0].difference.max_steps = 2;
    report.comparisons[0].difference.histogram[2] = 5;
    const nlohmann::json data = data_of(report_html(report));
    CHECK(data["comparisons"][0]["histogram"] == nlohmann::json({0, 0, 5}));
}

TEST_CASE("the summary parts the error of nv17 into factorisation and arithmetic") {
    Report report;
    report.comparisons = {comparison("ideal64", "exact", 9.0), comparison("nv17", "exact", 9.25),
                          comparison("nv17", "ideal64", 0.75), comparison("gl13", "exact", 9.1)};
    CHECK(summary_sentence(report) ==
          "nv17 differs from exact by 9.25 of 255 steps RMS: the factorisation alone makes 9.00, "
          "the preset's arithmetic alone 0.75.");
}

TEST_CASE("the summary makes do with the comparisons that there are") {
    Report report;
    report.comparisons = {comparison("gl13", "exact", 2.0)};
    CHECK(summary_sentence(report) == "gl13 differs from exact by 2.00 of 255 steps RMS.");
    report.comparisons = {comparison("ideal64", "exact", 2.0)};
    CHECK(summary_sentence(report) == "ideal64 differs from exact by 2.00 of 255 steps RMS.");
    report.comparisons = {comparison("nv17", "ideal64", 2.0)};
    CHECK(summary_sentence(report) == "No picture was compared with the exact one.");
    report.comparisons = {comparison("coarse8", "exact", 0.0)};
    report.comparisons[0].difference.pixels_compared = 0;
    CHECK(summary_sentence(report) == "coarse8 has no pixel in common with the exact picture.");
}

TEST_CASE("the same report gives the same page", "[long]") {
    CHECK(report_html(sample_report()) == report_html(sample_report()));
}

// For tests/study/report_page.sh: TWOFOLD_REPORT_SAMPLE names the file to write.
TEST_CASE("a sample report is written", "[.sample]") {
    const char* path = std::getenv("TWOFOLD_REPORT_SAMPLE");
    REQUIRE(path != nullptr);
    std::ofstream file(path, std::ios::binary);
    file << report_html(sample_report());
    REQUIRE(file.flush());
}
