// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_IO_STROKE_FONT_H
#define CGAL_MULTIPLANAR_IO_STROKE_FONT_H

#include <CGAL/Multiplanar/internal/kernel.h>

#include <cstring>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// The glyphs of the characters 32 to 126 in the simplex sans-serif Hershey font, as drawn by `futural.jhf`.
///
/// The Hershey Fonts were originally created by Dr. A. V. Hershey while working at the U. S. National Bureau of
/// Standards. The format of the Font data in this distribution was originally created by James Hurt, Cognition, Inc.,
/// 900 Technology Park Drive, Billerica, MA 01821 (mit-eddie!ci-dandelion!hurt).
///
/// Each pair of letters is a point, counted from 'R', y downward; the first pair is the left and the right end of the
/// glyph; " R" lifts the pen. Capital letters reach from y = 9 (the base line) up to y = -12.
// clang-format off
inline const char* hershey_glyph(char c)
{
  static const char* const glyphs[] = {
      R"(JZ)",
      R"(MWRFRT RRYQZR[SZRY)",
      R"(JZNFNM RVFVM)",
      R"(H]SBLb RYBRb RLOZO RKUYU)",
      R"(H\PBP_ RTBT_ RYIWGTFPFMGKIKKLMMNOOUQWRXSYUYXWZT[P[MZKX)",
      R"(F^[FI[ RNFPHPJOLMMKMIKIIJGLFNFPGSHVHYG[F RWTUUTWTYV[X[ZZ[X[VYTWT)",
      R"(E_\O\N[MZMYNXPVUTXRZP[L[JZIYHWHUISJRQNRMSKSIRGPFNGMIMKNNPQUXWZY[[[\Z\Y)",
      R"(MWRHQGRFSGSIRKQL)",
      R"(KYVBTDRGPKOPOTPYR]T`Vb)",
      R"(KYNBPDRGTKUPUTTYR]P`Nb)",
      R"(JZRLRX RMOWU RWOMU)",
      R"(E_RIR[ RIR[R)",
      R"(NVSWRXQWRVSWSYQ[)",
      R"(E_IR[R)",
      R"(NVRVQWRXSWRV)",
      R"(G][BIb)",
      R"(H\QFNGLJKOKRLWNZQ[S[VZXWYRYOXJVGSFQF)",
      R"(H\NJPISFS[)",
      R"(H\LKLJMHNGPFTFVGWHXJXLWNUQK[Y[)",
      R"(H\MFXFRNUNWOXPYSYUXXVZS[P[MZLYKW)",
      R"(H\UFKTZT RUFU[)",
      R"(H\WFMFLOMNPMSMVNXPYSYUXXVZS[P[MZLYKW)",
      R"(H\XIWGTFRFOGMJLOLTMXOZR[S[VZXXYUYTXQVOSNRNOOMQLT)",
      R"(H\YFO[ RKFYF)",
      R"(H\PFMGLILKMMONSOVPXRYTYWXYWZT[P[MZLYKWKTLRNPQOUNWMXKXIWGTFPF)",
      R"(H\XMWPURRSQSNRLPKMKLLINGQFRFUGWIXMXRWWUZR[P[MZLX)",
      R"(NVROQPRQSPRO RRVQWRXSWRV)",
      R"(NVROQPRQSPRO RSWRXQWRVSWSYQ[)",
      R"(F^ZIJRZ[)",
      R"(E_IO[O RIU[U)",
      R"(F^JIZRJ[)",
      R"(I[LKLJMHNGPFTFVGWHXJXLWNVORQRT RRYQZR[SZRY)",
      R"(E`WNVLTKQKOLNMMPMSNUPVSVUUVS RQKOMNPNSOUPV RWKVSVUXVZV\T]Q]O\L[JYHWGTFQFNGLHJJILHOHRIUJWLYNZQ[T[WZYYZX RXKWSWUXV)",
      R"(I[RFJ[ RRFZ[ RMTWT)",
      R"(G\KFK[ RKFTFWGXHYJYLXNWOTP RKPTPWQXRYTYWXYWZT[K[)",
      R"(H]ZKYIWGUFQFOGMILKKNKSLVMXOZQ[U[WZYXZV)",
      R"(G\KFK[ RKFRFUGWIXKYNYSXVWXUZR[K[)",
      R"(H[LFL[ RLFYF RLPTP RL[Y[)",
      R"(HZLFL[ RLFYF RLPTP)",
      R"(H]ZKYIWGUFQFOGMILKKNKSLVMXOZQ[U[WZYXZVZS RUSZS)",
      R"(G]KFK[ RYFY[ RKPYP)",
      R"(NVRFR[)",
      R"(JZVFVVUYTZR[P[NZMYLVLT)",
      R"(G\KFK[ RYFKT RPOY[)",
      R"(HYLFL[ RL[X[)",
      R"(F^JFJ[ RJFR[ RZFR[ RZFZ[)",
      R"(G]KFK[ RKFY[ RYFY[)",
      R"(G]PFNGLIKKJNJSKVLXNZP[T[VZXXYVZSZNYKXIVGTFPF)",
      R"(G\KFK[ RKFTFWGXHYJYMXOWPTQKQ)",
      R"(G]PFNGLIKKJNJSKVLXNZP[T[VZXXYVZSZNYKXIVGTFPF RSWY])",
      R"(G\KFK[ RKFTFWGXHYJYLXNWOTPKP RRPY[)",
      R"(H\YIWGTFPFMGKIKKLMMNOOUQWRXSYUYXWZT[P[MZKX)",
      R"(JZRFR[ RKFYF)",
      R"(G]KFKULXNZQ[S[VZXXYUYF)",
      R"(I[JFR[ RZFR[)",
      R"(F^HFM[ RRFM[ RRFW[ R\FW[)",
      R"(H\KFY[ RYFK[)",
      R"(I[JFRPR[ RZFRP)",
      R"(H\YFK[ RKFYF RK[Y[)",
      R"(KYOBOb RPBPb ROBVB RObVb)",
      R"(KYKFY^)",
      R"(KYTBTb RUBUb RNBUB RNbUb)",
      R"(JZRDJR RRDZR)",
      R"(I[Ib[b)",
      R"(NVSKQMQORPSORNQO)",
      R"(I\XMX[ RXPVNTMQMONMPLSLUMXOZQ[T[VZXX)",
      R"(H[LFL[ RLPNNPMSMUNWPXSXUWXUZS[P[NZLX)",
      R"(I[XPVNTMQMONMPLSLUMXOZQ[T[VZXX)",
      R"(I\XFX[ RXPVNTMQMONMPLSLUMXOZQ[T[VZXX)",
      R"(I[LSXSXQWOVNTMQMONMPLSLUMXOZQ[T[VZXX)",
      R"(MYWFUFSGRJR[ ROMVM)",
      R"(I\XMX]W`VaTbQbOa RXPVNTMQMONMPLSLUMXOZQ[T[VZXX)",
      R"(I\MFM[ RMQPNRMUMWNXQX[)",
      R"(NVQFRGSFREQF RRMR[)",
      R"(MWRFSGTFSERF RSMS^RaPbNb)",
      R"(IZMFM[ RWMMW RQSX[)",
      R"(NVRFR[)",
      R"(CaGMG[ RGQJNLMOMQNRQR[ RRQUNWMZM\N]Q][)",
      R"(I\MMM[ RMQPNRMUMWNXQX[)",
      R"(I\QMONMPLSLUMXOZQ[T[VZXXYUYSXPVNTMQM)",
      R"(H[LMLb RLPNNPMSMUNWPXSXUWXUZS[P[NZLX)",
      R"(I\XMXb RXPVNTMQMONMPLSLUMXOZQ[T[VZXX)",
      R"(KXOMO[ ROSPPRNTMWM)",
      R"(J[XPWNTMQMNNMPNRPSUTWUXWXXWZT[Q[NZMX)",
      R"(MYRFRWSZU[W[ ROMVM)",
      R"(I\MMMWNZP[S[UZXW RXMX[)",
      R"(JZLMR[ RXMR[)",
      R"(G]JMN[ RRMN[ RRMV[ RZMV[)",
      R"(J[MMX[ RXMM[)",
      R"(JZLMR[ RXMR[P_NaLbKb)",
      R"(J[XMM[ RMMXM RM[X[)",
      R"(KYTBRCQDPFPHQJRKSMSOQQ RRCQEQGRISJTLTNSPORSTTVTXSZR[Q]Q_Ra RQSSUSWRYQZP\P^Q`RaTb)",
      R"(NVRBRb)",
      R"(KYPBRCSDTFTHSJRKQMQOSQ RRCSESGRIQJPLPNQPURQTPVPXQZR[S]S_Ra RSSQUQWRYSZT\T^S`RaPb)",
      R"(F^IUISJPLONOPPTSVTXTZS[Q RISJQLPNPPQTTVUXUZT[Q[O)",
  };
  return c >= 32 && c < 127 ? glyphs[c - 32] : glyphs['?' - 32];
}
// clang-format on

/// The glyphs of a text in UTF-8: printable ASCII, the degree sign and an arrow upward (U+2191), in Hershey's format
/// both. Anything else is a question mark.
inline std::vector<const char*> glyphs_of(const std::string& text)
{
  std::vector<const char*> glyphs;
  const auto begins = [&](std::size_t i, const char* sign) { return text.compare(i, std::strlen(sign), sign) == 0; };
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (begins(i, "\xc2\xb0")) glyphs.push_back("MWRFTGUITKRLPKOIPGRF"), i += 1;
    else if (begins(i, "\xe2\x86\x91")) glyphs.push_back("KYR[RF RMLRFWL"), i += 2;
    else glyphs.push_back(hershey_glyph(text[i]));
  }
  return glyphs;
}

constexpr double hershey_cap_height = 21;
constexpr double hershey_base_line = 9;

} // namespace internal

/// A line that a laser or a pen draws in one go.
using Stroke = std::vector<Kernel::Point_2>;

/// Width of `text` when its capital letters are 1 high.
inline double text_width(const std::string& text)
{
  double sum = 0;
  for (const char* glyph : internal::glyphs_of(text)) {
    sum += glyph[1] - glyph[0];
  }
  return sum / internal::hershey_cap_height;
}

/// The single strokes of `text` with capital letters 1 high, y upward, the middle of the text (half its width, half the
/// height of a capital) at the origin. What is neither printable
/// ASCII nor a degree sign nor U+2191 (an arrow upward) is drawn as question marks.
inline std::vector<Stroke> text_strokes(const std::string& text)
{
  std::vector<Stroke> strokes;
  double pen = -text_width(text) / 2;
  for (const char* glyph : internal::glyphs_of(text)) {
    const int left = glyph[0] - 'R', right = glyph[1] - 'R';
    Stroke stroke;
    const auto lift = [&] {
      if (stroke.size() > 1) strokes.push_back(stroke);
      stroke.clear();
    };
    for (const char* p = glyph + 2; *p != 0; p += 2) {
      if (p[0] == ' ') {
        lift();
        continue;
      }
      const double x = p[0] - 'R' - left, y = internal::hershey_base_line - (p[1] - 'R');
      stroke.emplace_back(pen + x / internal::hershey_cap_height, y / internal::hershey_cap_height - 0.5);
    }
    lift();
    pen += (right - left) / internal::hershey_cap_height;
  }
  return strokes;
}

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_IO_STROKE_FONT_H
