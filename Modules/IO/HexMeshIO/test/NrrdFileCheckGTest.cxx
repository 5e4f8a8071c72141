// The check of NRRD headers: what is refused under which code, and what is read as the header says.
#include "ImageCheckErrors.h"

#include <sys/stat.h>
#include <unistd.h>

using namespace moserhex;

TEST(NrrdCheck, BrokenHeadersAreRefusedByCode)
{
  const TestFolder           folder;
  const std::vector<Refusal> refusals{
    { "type", "", "E_HEADER" },
    { "type", "banana", "E_HEADER" },
    { "type", "block", "E_PIXELTYPE" },
    { "type", "int16", "E_HEADER" }, // no byte order
    { "endian", "middle", "E_HEADER" },
    { "dimension", "0", "E_HEADER" },
    { "dimension", "17", "E_HEADER" },
    { "dimension", "2", "E_HEADER" }, // three sizes
    { "dimension", "3 3", "E_HEADER" },
    { "sizes", "5 4", "E_HEADER" },
    { "sizes", "5 4 3.5", "E_HEADER" },
    { "sizes", "5 4 -3", "E_HEADER" },
    { "sizes", "5 0 3", "E_HEADER" },
    { "sizes", std::string(200, '1') + " 1 1", "E_HEADER" },
    { "sizes", "99999999999999999999 1 1", "E_TOO_BIG" },
    { "sizes", "3 12297829382473034744 1", "E_TOO_BIG" },
    { "sizes", "100000 100000 100000", "E_TOO_BIG" },
    { "sizes", "5 4 4", "E_TRUNCATED" },
    { "kinds", "domain domain", "E_HEADER" },
    { "space", "right-up", "E_HEADER" },
    { "space", "left-posterior-superior-time", "E_DIMENSION" },
    { "space dimension", "3", "E_HEADER" }, // beside space
    { "space directions", "none none none", "E_GEOMETRY" },
    { "space directions", "(1,0,0) (0,1,0) none", "E_DIMENSION" },
    { "space directions", "(1,0,0) (0,1,0)", "E_HEADER" },
    { "space directions", "(1,0) (0,1) (0,0)", "E_HEADER" },
    { "space directions", "(1,0,0) (0,1,0) 3", "E_HEADER" },
    { "space directions", "(1,0,0) (0,1,0) (0,0,x)", "E_HEADER" },
    { "space directions", "(1,0,0) (0,1,0) (0,0,1e30)", "E_GEOMETRY" },
    { "space directions", "(1,0,0) (0,1,0) (0,0,1e-9)", "E_GEOMETRY" },
    { "space directions", "(1,0,0) (0,1,0) (0,0,nan)", "E_GEOMETRY" },
    { "space directions", "(1,0,0) (0.5,1,0) (0,0,1)", "E_GEOMETRY" },
    { "space origin", "(nan,0,0)", "E_GEOMETRY" },
    { "space origin", "(1e9,0,0)", "E_GEOMETRY" },
    { "space origin", "none", "E_HEADER" },
    { "spacings", "1 1 1", "E_HEADER" },
    { "axis mins", "0 0 0", "E_UNSUPPORTED" },
    { "space units", "\"um\" \"um\" \"um\"", "E_GEOMETRY" },
    { "encoding", "", "E_HEADER" },
    { "encoding", "hex", "E_UNSUPPORTED" },
    { "encoding", "bzip2", "E_UNSUPPORTED" },
    { "encoding", "rar", "E_HEADER" },
    { "encoding", "gzip", "E_CHECKSUM" }, // the voxels are raw
    { "line skip", "2000000000", "E_HEADER" },
    { "line skip", "1", "E_UNSUPPORTED" },
    { "byte skip", "9000000000000000000", "E_HEADER" },
    { "content", std::string(600, 'c'), "E_HEADER" },
    { "data file", "/dev/zero", "E_REFERENCE" },
    { "data file", "../a.raw", "E_REFERENCE" },
    { "data file", "slice%d.raw 0 9 1", "E_REFERENCE" },
    { "data file", "LIST", "E_REFERENCE" },
    { "data file", "a.nrrd", "E_REFERENCE" },
    { "data file", "missing.raw", "E_REFERENCE" },
  };
  for (const Refusal & refusal : refusals)
  {
    writeBytes(folder / "a.nrrd", ImageText::nrrd().with(refusal.key, refusal.value).file());
    EXPECT_EQ(checkErrorCode(folder / "a.nrrd"), refusal.code) << refusal.key << ": " << refusal.value << '\n'
                                                               << checkError(folder / "a.nrrd");
  }
}

TEST(NrrdCheck, LinesThatAreNoFieldsAreRefused)
{
  const TestFolder folder;
  for (const std::string & line : { std::string("nonsense"),
                                    std::string("sizes:5 4 3"),
                                    std::string("type: uint8"), // twice
                                    std::string(":=value"),
                                    std::string(8192, 'A'),
                                    std::string("a\0b: c", 6) })
  {
    writeBytes(folder / "a.nrrd", ImageText::nrrd().withLine(line).file());
    EXPECT_EQ(checkErrorCode(folder / "a.nrrd"), "E_HEADER") << line;
  }
  writeBytes(folder / "a.nrrd", ImageText::nrrd().with("dimension", "").withLine("dimension: 3").file());
  EXPECT_NE(checkError(folder / "a.nrrd").find("stands before 'dimension'"), std::string::npos);
  writeBytes(folder / "a.nrrd", ImageText::nrrd().with("space", "").withLine("space: LPS").file());
  EXPECT_NE(checkError(folder / "a.nrrd").find("stands before 'space'"), std::string::npos);
}

TEST(NrrdCheck, MagicAndEndOfTheHeaderAreNeeded)
{
  const TestFolder  folder;
  const std::string good = ImageText::nrrd().file();
  for (const auto & [bytes, code] : { std::pair(std::string("NRRD0006") + good.substr(8), "E_UNSUPPORTED"),
                                      std::pair(std::string("NRRX0004") + good.substr(8), "E_FORMAT"),
                                      std::pair("NRRD0004" + std::string(100'000, 'x'), "E_HEADER"),
                                      std::pair(std::string("NRRD0004\ntype: uint8"), "E_HEADER") })
  {
    writeBytes(folder / "a.nrrd", bytes);
    EXPECT_EQ(checkErrorCode(folder / "a.nrrd"), code) << bytes.substr(0, 20);
  }
}

TEST(NrrdCheck, LongCommentsAndKeysPass)
{
  const TestFolder folder;
  writeBytes(folder / "a.nrrd",
             ImageText::nrrd()
               .withLine("# " + std::string(300'000, 'c') + "%s%n")
               .withLine(std::string(5000, 'k') + ":=" + std::string(100'000, 'v') + "%s%n: x")
               .file());
  expectTestVoxels(readHere(folder / "a.nrrd"));
}

TEST(NrrdCheck, CarriageReturnsPass)
{
  const TestFolder folder;
  std::string      header = ImageText::nrrd().header();
  for (std::size_t at = 0; (at = header.find('\n', at)) != std::string::npos; at += 2)
  {
    header.insert(at, "\r");
  }
  writeBytes(folder / "a.nrrd", header + ImageText::voxels());
  expectTestVoxels(readHere(folder / "a.nrrd"));
}

TEST(NrrdCheck, CarriageReturnWithinALineIsRefused)
{
  // To ITK's library a new line begins there: a field that is hidden from the check, or a rest that it dies of.
  const TestFolder folder;
  for (const std::string & rest : { std::string("encoding: gzip"), std::string(1300, 'A') })
  {
    writeBytes(folder / "a.nrrd", ImageText::nrrd().withLine("# comment\r" + rest).file());
    EXPECT_EQ(checkErrorCode(folder / "a.nrrd"), "E_HEADER") << rest.size();
  }
}

TEST(NrrdCheck, SpacesAreTurnedIntoLps)
{
  const TestFolder folder;
  const auto       originOf = [&](const std::string & space) {
    writeBytes(folder / "a.nrrd", ImageText::nrrd().with("space", space).file());
    const ImageDescription image = checkImageFile(folder / "a.nrrd", ImageFormat::Nrrd);
    EXPECT_EQ(image.warnings.empty(), space != "scanner-xyz") << space;
    EXPECT_EQ(image.grid.spacing, Vector3(0.5, 0.75, 2.0));
    EXPECT_EQ((image.grid.direction * Vector3(1.0, 2.0, 3.0)), image.grid.origin) << space; // header: origin (1,2,3)
    return image.grid.origin;
  };
  EXPECT_EQ(originOf("LPS"), Vector3(1.0, 2.0, 3.0));
  EXPECT_EQ(originOf("Right-Anterior-Superior"), Vector3(-1.0, -2.0, 3.0));
  EXPECT_EQ(originOf("las"), Vector3(1.0, -2.0, 3.0));
  EXPECT_EQ(originOf("scanner-xyz"), Vector3(1.0, 2.0, 3.0));
}

TEST(NrrdCheck, WithoutSpaceOrSizesThereIsAWarning)
{
  const TestFolder folder;
  const auto       warningsOf = [&](const ImageText & text) {
    writeBytes(folder / "a.nrrd", text.file());
    std::string all;
    for (const std::string & warning : checkImageFile(folder / "a.nrrd", ImageFormat::Nrrd).warnings)
    {
      all += warning + '\n';
    }
    return all;
  };
  const ImageText plain =
    ImageText::nrrd().with("space", "").with("space directions", "").with("space origin", "").with("encoding", "raw");
  EXPECT_NE(warningsOf(plain).find("1 mm assumed"), std::string::npos);
  EXPECT_NE(warningsOf(plain).find("no anatomical space"), std::string::npos);
  EXPECT_EQ(warningsOf(plain.with("spacings", "0.5 0.5 2")).find("1 mm assumed"), std::string::npos);
  const std::string turned = warningsOf(ImageText::nrrd().with("space directions", "(1,0,0) (1e-4,1,0) (0,0,1)"));
  EXPECT_NE(turned.find("turned to right angles"), std::string::npos) << turned;
}

TEST(NrrdCheck, ExtraAxesAreRefusedByName)
{
  const TestFolder folder;
  const auto       errorFor = [&](const char * sizes, const char * kinds, const char * directions) {
    writeBytes(folder / "a.nrrd",
               ImageText::nrrd()
                   .with("dimension", "4")
                   .with("sizes", sizes)
                   .with("kinds", kinds)
                   .with("space directions", directions)
                   .header() +
                 std::string(240, '\0'));
    return checkError(folder / "a.nrrd");
  };
  const char * first = "none (1,0,0) (0,1,0) (0,0,1)";
  const char * last = "(1,0,0) (0,1,0) (0,0,1) none";
  EXPECT_NE(errorFor("5 4 3 2", "domain domain domain time", last).find("E_DIMENSION"), std::string::npos);
  EXPECT_NE(errorFor("2 5 4 3", "list domain domain domain", first).find("E_DIMENSION"), std::string::npos);
  EXPECT_NE(errorFor("3 5 4 3", "RGB-color domain domain domain", first).find("E_PIXELTYPE"), std::string::npos);
  EXPECT_NE(errorFor("2 5 4 3", "vector domain domain domain", first).find("E_PIXELTYPE"), std::string::npos);
}

TEST(NrrdCheck, AxesOfSizeOneAreNoMatter)
{
  const TestFolder folder;
  writeBytes(folder / "first.nrrd",
             ImageText::nrrd()
               .with("dimension", "4")
               .with("sizes", "1 5 4 3")
               .with("kinds", "list domain domain domain")
               .with("space directions", "none (0.5,0,0) (0,0.75,0) (0,0,2)")
               .file());
  writeBytes(folder / "last.nrrd",
             ImageText::nrrd()
               .with("dimension", "4")
               .with("sizes", "5 4 3 1")
               .with("kinds", "domain domain domain list")
               .with("space directions", "(0.5,0,0) (0,0.75,0) (0,0,2) none")
               .file());
  expectTestVoxels(readHere(folder / "first.nrrd"));
  expectTestVoxels(readHere(folder / "last.nrrd"));
}

TEST(NrrdCheck, DataBesideTheHeaderAreRead)
{
  const TestFolder folder;
  writeBytes(folder / "my data.raw", ImageText::voxels());
  writeBytes(folder / "a.nhdr", ImageText::nrrd().with("data file", "my data.raw").header());
  expectTestVoxels(readHere(folder / "a.nhdr"));
  writeBytes(folder / "my data.raw", ImageText::voxels().substr(1));
  EXPECT_EQ(checkErrorCode(folder / "a.nhdr"), "E_TRUNCATED");
}

TEST(NrrdCheck, LinkOutOfTheFolderAndPipeAreNoData)
{
  const TestFolder folder;
  const TestFolder elsewhere;
  writeBytes(elsewhere / "other.raw", ImageText::voxels());
  ASSERT_EQ(::symlink((elsewhere / "other.raw").c_str(), (folder / "link.raw").c_str()), 0);
  ASSERT_EQ(::mkfifo((folder / "pipe.raw").c_str(), 0600), 0);
  for (const char * name : { "link.raw", "pipe.raw" })
  {
    writeBytes(folder / "a.nhdr", ImageText::nrrd().with("data file", name).header());
    EXPECT_EQ(checkErrorCode(folder / "a.nhdr"), "E_REFERENCE") << name;
  }
}

TEST(NrrdCheck, BytesToSkipAreSkipped)
{
  const TestFolder folder;
  for (const char * skip : { "4", "-1" })
  {
    writeBytes(folder / "a.nrrd",
               ImageText::nrrd().with("byte skip", skip).header() + "\1\1\1\1" + ImageText::voxels());
    expectTestVoxels(readHere(folder / "a.nrrd"));
  }
}

TEST(NrrdCheck, EveryNumberTypeAndByteOrderIsRead)
{
  const TestFolder folder;
  const auto       expectRead = [&](const char * type, const std::string & voxels, const char * endian) {
    writeBytes(folder / "a.nrrd", ImageText::nrrd().with("type", type).with("endian", endian).header() + voxels);
    SCOPED_TRACE(type);
    expectTestVoxels(readHere(folder / "a.nrrd"));
  };
  for (const bool big : { false, true })
  {
    const char * endian = big ? "big" : "little"; // of a little-endian machine
    expectRead("int8", voxelsAs<std::int8_t>(big), endian);
    expectRead("short", voxelsAs<std::int16_t>(big), endian);
    expectRead("uint16", voxelsAs<std::uint16_t>(big), endian);
    expectRead("int", voxelsAs<std::int32_t>(big), endian);
    expectRead("uint32_t", voxelsAs<std::uint32_t>(big), endian);
    expectRead("long long", voxelsAs<std::int64_t>(big), endian);
    expectRead("uint64", voxelsAs<std::uint64_t>(big), endian);
    expectRead("float", voxelsAs<float>(big), endian);
    expectRead("double", voxelsAs<double>(big), endian);
  }
}

TEST(NrrdCheck, TextIsReadNumberByNumber)
{
  const TestFolder  folder;
  const std::string header = ImageText::nrrd().with("encoding", "ascii").header();
  std::string       text;
  for (const char voxel : ImageText::voxels())
  {
    text += std::to_string(static_cast<int>(voxel)) + '\n';
  }
  writeBytes(folder / "a.nrrd", header + text);
  expectTestVoxels(readHere(folder / "a.nrrd"));
  EXPECT_TRUE(checkImageFile(folder / "a.nrrd", ImageFormat::Nrrd).warnings.empty());
  for (const auto & [bytes, code] : { std::pair(text.substr(0, text.size() - 2), "E_TRUNCATED"),
                                      std::pair("300 " + text, "E_HEADER"),
                                      std::pair("0.5 " + text, "E_HEADER"),
                                      std::pair(std::string(1000, '1') + text, "E_HEADER") })
  {
    writeBytes(folder / "a.nrrd", header + bytes);
    EXPECT_EQ(checkErrorCode(folder / "a.nrrd"), code) << bytes.substr(0, 10);
  }
  writeBytes(folder / "a.nrrd", header + text + "7 8\n");
  EXPECT_EQ(checkImageFile(folder / "a.nrrd", ImageFormat::Nrrd).warnings.size(), 1u);
}
