#!/usr/bin/env python3
"""Makes the fonts of crates/lagrange-plot/letters: the characters of STIX Two that labels of mechanics need, without further tables.

    tools/letters.py FOLDER     with STIXTwoText-Regular.ttf, STIXTwoText-Italic.ttf, STIXTwoMath-Regular.ttf and OFL.txt of version
                                2.13 b171: https://github.com/stipub/stixfonts/tree/v2.13b171, fonts/static_ttf

Needs Python 3 and fontTools 4.68 (`pip install fonttools==4.68.0`; other versions may order bytes differently). The same files give the
same bytes. Kerning pairs are written as a table `kern`, which takes a few lines to read, unlike the layout tables from
which they come. Italics are for symbols: letters only.

The licence is that of the fonts, the SIL Open Font License 1.1, whose text is included. The name that it reserves, "TM Math", belongs to
a font from which STIX descends. The subsets are called Lagrange Letters, since they are not the complete STIX Two.
"""

import hashlib
import io
import shutil
import sys
from pathlib import Path

from fontTools.merge import Merger
from fontTools.subset import Options, Subsetter
from fontTools.ttLib import TTFont, newTable
from fontTools.ttLib.tables._k_e_r_n import KernTable_format_0

LETTERS = Path(__file__).resolve().parent.parent / "crates" / "lagrange-plot" / "letters"
SOURCES = {
    "STIXTwoText-Regular.ttf": "0566a1be411c0b2463fad8563b33f1c299442b8882c7fce9ef95e079f43233da",
    "STIXTwoText-Italic.ttf": "5a0ed1c0c1d3d4f83f2d00bcd4a0a991a7b0755beacee0a57b26762327a84c22",
    "STIXTwoMath-Regular.ttf": "49b22767985171bce579307b21d98f4d35012fa39e316acc4ffcab8644dfb69b",
    "OFL.txt": "0c8825913b60d858aacdb33c4ca6660a7d64b0d6464702efbb19313f5765861a",
}
# The day of version 2.13, in seconds since 1904.
RELEASED = 3_704_832_000


def span(first, last):
    return set(range(first, last + 1))


GREEK = span(0x391, 0x3A1) | span(0x3A3, 0x3A9) | span(0x3B1, 0x3C9) | {ord(c) for c in "ϑϕϖϱϵ"}
LATIN = span(ord("A"), ord("Z")) | span(ord("a"), ord("z"))
# Grave, acute, circumflex, tilde, bar, breve, one and two dots, ring, double acute, caron, three and four dots, arrow.
ACCENTS = span(0x300, 0x304) | span(0x306, 0x308) | {0x30A, 0x30B, 0x30C, 0x20D7, 0x20DB, 0x20DC}
DOTTED = {ord(c) for c in "ẊẋẌẍẎẏẄẅṘṙṠṡṪṫṖṗṀṁṄṅḞḟḊḋĊċĠġŻżĖėİẆẇ"}
PRIMES = {ord(c) for c in "'′″‴"}
ITALIC = LATIN | GREEK | ACCENTS | DOTTED | PRIMES | {ord(c) for c in "ıȷℓ"} | span(0xC0, 0xFF)
CYRILLIC = span(0x410, 0x44F) | {ord(c) for c in "ЁёЄєІіЇїҐґ"}
SIGNS = {ord(c) for c in "–—‘’‚“”„†‡•…‰‹›⁄€™−⁰⁴⁵⁶⁷⁸⁹⁺⁻⁼⁽⁾ⁿ₀₁₂₃₄₅₆₇₈₉₊₋℃ℓΩ№⅓⅔⅛"} | span(0x20, 0x7E) | span(0xA0, 0xFF)
UPRIGHT = ITALIC | SIGNS | CYRILLIC | span(0x100, 0x17F)
OPERATORS = {ord(c) for c in "←↑→↓↔↦⇒⇔∀∂∃∆∇∈∏∑∓∗∘∙√∝∞∟∠∡∥∧∨∫∮∴∼≃≅≈≠≡≤≥≪≫⊕⊗⊥⋅⋯⟂⟨⟩ℏ↶↷↺↻�■□○●△"}


def main():
    folder = Path(sys.argv[1])
    sources = {name: read(folder / name, digest) for name, digest in SOURCES.items()}
    LETTERS.mkdir(exist_ok=True)
    text = subset(sources["STIXTwoText-Regular.ttf"], UPRIGHT)
    signs = subset(sources["STIXTwoMath-Regular.ttf"], OPERATORS - characters(text))
    if lost := (UPRIGHT | OPERATORS) - characters(text) - characters(signs):
        sys.exit("not in these fonts: " + "".join(map(chr, sorted(lost))))
    pairs = kerning(sources["STIXTwoText-Regular.ttf"], text)
    write(merged(text, signs), pairs, "Upright", LETTERS / "upright.ttf")
    italic = subset(sources["STIXTwoText-Italic.ttf"], ITALIC)
    write(italic, {}, "Italic", LETTERS / "italic.ttf")
    shutil.copyfile(folder / "OFL.txt", LETTERS / "OFL.txt")


def read(path, digest):
    data = path.read_bytes()
    if hashlib.sha256(data).hexdigest() != digest:
        sys.exit(f"{path} is not the file of version 2.13 b171")
    return data


def subset(data, wanted):
    """Returns a font with these characters and the components of their outlines; it keeps its box for all others."""
    options = Options()
    options.layout_features = []
    options.notdef_outline = True
    options.hinting = False
    options.glyph_names = False
    options.name_IDs = [0, 13, 14]
    options.drop_tables += ["DSIG", "GDEF", "GPOS", "GSUB", "MATH", "STAT", "gasp", "meta", "FFTM"]
    font = TTFont(io.BytesIO(data), recalcTimestamp=False)
    subsetter = Subsetter(options)
    subsetter.populate(unicodes=wanted)
    subsetter.subset(font)
    return font


def characters(font):
    return set(font.getBestCmap())


def merged(*fonts):
    files = []
    for font in fonts:
        files.append(io.BytesIO())
        font.save(files[-1])
        files[-1].seek(0)
    return Merger().merge(files)


def kerning(data, kept):
    """Returns pairs of ASCII characters and Greek letters that the layout tables move, with the distances."""
    font = TTFont(io.BytesIO(data))
    glyphs = {glyph: code for code, glyph in font.getBestCmap().items() if code in PAIRED}
    table = font["GPOS"].table
    wanted = {index for record in table.FeatureList.FeatureRecord if record.FeatureTag == "kern"
              for index in record.Feature.LookupListIndex}
    pairs = {}
    for index in sorted(wanted):
        found = {}
        for part in table.LookupList.Lookup[index].SubTable:
            part = part.ExtSubTable if part.LookupType == 9 else part
            if part.LookupType == 2:
                # The first subtable with a pair decides.
                for pair, value in adjusted(part, glyphs):
                    found.setdefault(pair, value)
        for pair, value in found.items():
            pairs.setdefault(pair, value)
    return {pair: value for pair, value in pairs.items() if value}


PAIRED = LATIN | {ord(c) for c in " .,;:()[]-–’'\"/0123456789"}


def adjusted(part, glyphs):
    """Returns pairs of characters of one subtable."""
    advance = lambda value: getattr(value, "XAdvance", 0) or 0
    firsts = [glyph for glyph in part.Coverage.glyphs if glyph in glyphs]
    if part.Format == 1:
        sets = dict(zip(part.Coverage.glyphs, part.PairSet))
        for first in firsts:
            for record in sets[first].PairValueRecord:
                if record.SecondGlyph in glyphs:
                    yield (glyphs[first], glyphs[record.SecondGlyph]), advance(record.Value1)
        return
    for first in firsts:
        row = part.Class1Record[part.ClassDef1.classDefs.get(first, 0)].Class2Record
        for second, code in glyphs.items():
            yield (glyphs[first], code), advance(row[part.ClassDef2.classDefs.get(second, 0)].Value1)


def write(font, pairs, style, path):
    names = font.getBestCmap()
    if pairs:
        table = KernTable_format_0()
        table.version, table.coverage, table.tupleIndex = 0, 1, None
        table.kernTable = {(names[a], names[b]): value for (a, b), value in pairs.items()}
        font["kern"] = newTable("kern")
        font["kern"].version, font["kern"].kernTables = 0, [table]
    for number, name in [(1, "Lagrange Letters"), (2, style), (4, f"Lagrange Letters {style}"), (6, f"LagrangeLetters-{style}")]:
        font["name"].setName(name, number, 3, 1, 0x409)
    font["head"].created = font["head"].modified = RELEASED
    font.recalcTimestamp = False
    font.save(path)
    print(f"{path.name}: {len(names)} characters, {len(pairs)} pairs, {path.stat().st_size} bytes")


if __name__ == "__main__":
    main()
