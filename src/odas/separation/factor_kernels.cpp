// SPDX-License-Identifier: MIT
#include "odas/separation/factor_kernels.hpp"

#include "odas/base/contract.hpp"

// Vectors whose length the compiler does not know do not divide a block: on ARM, NEON does.
#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "odas/separation/factor_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace odas {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, kBlockBins>;
using Vector = hn::Vec<Floats>;

/// Neighbouring bins of one row.
struct Complex {
  Vector re, im;
};

HWY_INLINE Complex Get(const float* p) {
  const Floats d;
  return {hn::LoadU(d, p), hn::LoadU(d, p + kBlockBins)};
}
HWY_INLINE void Put(const Complex& z, float* p) {
  const Floats d;
  hn::StoreU(z.re, d, p);
  hn::StoreU(z.im, d, p + kBlockBins);
}

/// Calls f(block, lane) for each vector of bins.
template <class F>
HWY_INLINE void EachVector(std::size_t blocks, const F& f) {
  const std::size_t lanes = hn::Lanes(Floats());
  for (std::size_t b = 0; b < blocks; ++b) {
    for (std::size_t lane = 0; lane < kBlockBins; lane += lanes) f(b, lane);
  }
}

/// `first`: the first microphone whose entry of v is not zero. Without `keep`, nothing fades.
void Update(BinBlocks& factor, const float* keep, BinBlocks& v, std::size_t first) {
  const std::size_t mics = v.rows();
  EachVector(v.blocks(), [&](std::size_t b, std::size_t lane) {
    const Floats d;
    const auto fade =
        keep == nullptr ? hn::Set(d, 1.F) : hn::Sqrt(hn::LoadU(d, keep + b * kBlockBins + lane));
    for (std::size_t k = first; k < mics; ++k) {
      float* diagonal = factor.at(b, factor_row(mics, k, k)) + lane;
      const Complex x = Get(v.at(b, k) + lane);
      const auto l = hn::Mul(fade, hn::LoadU(d, diagonal));
      const auto r = hn::Sqrt(hn::MulAdd(l, l, hn::MulAdd(x.re, x.re, hn::Mul(x.im, x.im))));
      const auto inverse = hn::Div(hn::Set(d, 1.F), l);
      const auto c = hn::Mul(r, inverse);
      const auto back = hn::Div(l, r);
      const auto sr = hn::Mul(x.re, inverse);
      const auto si = hn::Mul(x.im, inverse);
      hn::StoreU(r, d, diagonal);
      for (std::size_t i = k + 1; i < mics; ++i) {
        float* entry = factor.at(b, factor_row(mics, i, k)) + lane;
        Complex a = Get(entry);
        Complex y = Get(v.at(b, i) + lane);
        a.re = hn::Mul(back, hn::MulAdd(fade, a.re, hn::MulAdd(sr, y.re, hn::Mul(si, y.im))));
        a.im = hn::Mul(back, hn::MulAdd(fade, a.im, hn::NegMulAdd(si, y.re, hn::Mul(sr, y.im))));
        y.re = hn::MulAdd(c, y.re, hn::NegMulAdd(sr, a.re, hn::Mul(si, a.im)));
        y.im = hn::NegMulAdd(sr, a.im, hn::NegMulAdd(si, a.re, hn::Mul(c, y.im)));
        Put(a, entry);
        Put(y, v.at(b, i) + lane);
      }
    }
  });
}

void Forward(const BinBlocks& factor, BinBlocks& v, BinReals& norm) {
  const std::size_t mics = v.rows();
  EachVector(v.blocks(), [&](std::size_t b, std::size_t lane) {
    const Floats d;
    auto sum = hn::Zero(d);
    for (std::size_t i = 0; i < mics; ++i) {
      Complex y = Get(v.at(b, i) + lane);
      for (std::size_t k = 0; k < i; ++k) {
        const Complex a = Get(factor.at(b, factor_row(mics, i, k)) + lane);
        const Complex z = Get(v.at(b, k) + lane);
        y.re = hn::MulAdd(a.im, z.im, hn::NegMulAdd(a.re, z.re, y.re));
        y.im = hn::NegMulAdd(a.im, z.re, hn::NegMulAdd(a.re, z.im, y.im));
      }
      const auto inverse =
          hn::Div(hn::Set(d, 1.F), hn::LoadU(d, factor.at(b, factor_row(mics, i, i)) + lane));
      y = {hn::Mul(inverse, y.re), hn::Mul(inverse, y.im)};
      sum = hn::MulAdd(y.re, y.re, hn::MulAdd(y.im, y.im, sum));
      Put(y, v.at(b, i) + lane);
    }
    hn::StoreU(sum, d, norm.data() + b * kBlockBins + lane);
  });
}

void Backward(const BinBlocks& factor, BinBlocks& v) {
  const std::size_t mics = v.rows();
  EachVector(v.blocks(), [&](std::size_t b, std::size_t lane) {
    const Floats d;
    for (std::size_t i = mics; i-- > 0;) {
      Complex y = Get(v.at(b, i) + lane);
      for (std::size_t k = i + 1; k < mics; ++k) {  // y_i - sum conj(L_ki) y_k
        const Complex a = Get(factor.at(b, factor_row(mics, k, i)) + lane);
        const Complex z = Get(v.at(b, k) + lane);
        y.re = hn::NegMulAdd(a.im, z.im, hn::NegMulAdd(a.re, z.re, y.re));
        y.im = hn::MulAdd(a.im, z.re, hn::NegMulAdd(a.re, z.im, y.im));
      }
      const auto inverse =
          hn::Div(hn::Set(d, 1.F), hn::LoadU(d, factor.at(b, factor_row(mics, i, i)) + lane));
      Put({hn::Mul(inverse, y.re), hn::Mul(inverse, y.im)}, v.at(b, i) + lane);
    }
  });
}

void Inner(const BinBlocks& a, const BinBlocks& b, BinBlocks& out) {
  EachVector(a.blocks(), [&](std::size_t block, std::size_t lane) {
    const Floats d;
    Complex sum{hn::Zero(d), hn::Zero(d)};
    for (std::size_t m = 0; m < a.rows(); ++m) {
      const Complex x = Get(a.at(block, m) + lane);
      const Complex y = Get(b.at(block, m) + lane);
      sum.re = hn::MulAdd(x.im, y.im, hn::MulAdd(x.re, y.re, sum.re));
      sum.im = hn::NegMulAdd(x.im, y.re, hn::MulAdd(x.re, y.im, sum.im));
    }
    Put(sum, out.at(block, 0) + lane);
  });
}

void Column(BinBlocks& c, const BinReals& gain, const BinBlocks& x, std::size_t reference) {
  EachVector(c.blocks(), [&](std::size_t b, std::size_t lane) {
    const Floats d;
    const auto a = hn::LoadU(d, gain.data() + b * kBlockBins + lane);
    const auto keep = hn::Sub(hn::Set(d, 1.F), a);
    Complex r = Get(x.at(b, reference) + lane);
    r = {hn::Mul(a, r.re), hn::Mul(a, r.im)};
    for (std::size_t m = 0; m < c.rows(); ++m) {
      const Complex y = Get(x.at(b, m) + lane);
      Complex z = Get(c.at(b, m) + lane);
      z.re = hn::MulAdd(keep, z.re, hn::MulAdd(y.re, r.re, hn::Mul(y.im, r.im)));
      z.im = hn::MulAdd(keep, z.im, hn::NegMulAdd(y.re, r.im, hn::Mul(y.im, r.re)));
      Put(z, c.at(b, m) + lane);
    }
  });
}

}  // namespace HWY_NAMESPACE
}  // namespace odas
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace odas {

HWY_EXPORT(Update);
HWY_EXPORT(Forward);
HWY_EXPORT(Backward);
HWY_EXPORT(Inner);
HWY_EXPORT(Column);

void factor_update(BinBlocks& factor, const BinReals& keep, BinBlocks& v) noexcept {
  ODAS_EXPECT(factor.rows() == factor_rows(v.rows()) && factor.bins() == v.bins());
  ODAS_EXPECT(keep.bins() == v.bins());
  HWY_DYNAMIC_DISPATCH(Update)(factor, keep.data(), v, 0);
}

void factor_load(BinBlocks& factor, const BinReals& amplitude, std::size_t mic, BinBlocks& scratch) noexcept {
  ODAS_EXPECT(factor.rows() == factor_rows(scratch.rows()) && factor.bins() == scratch.bins());
  ODAS_EXPECT(amplitude.bins() == scratch.bins() && mic < scratch.rows());
  for (std::size_t b = 0; b < scratch.blocks(); ++b) {
    std::fill(scratch.at(b, 0), scratch.at(b, 0) + scratch.rows() * 2 * kBlockBins, 0.F);
    std::copy_n(amplitude.data() + b * kBlockBins, kBlockBins, scratch.at(b, mic));
  }
  HWY_DYNAMIC_DISPATCH(Update)(factor, nullptr, scratch, mic);
}

void factor_forward(const BinBlocks& factor, BinBlocks& v, BinReals& norm) noexcept {
  ODAS_EXPECT(factor.rows() == factor_rows(v.rows()) && factor.bins() == v.bins());
  ODAS_EXPECT(norm.bins() == v.bins());
  HWY_DYNAMIC_DISPATCH(Forward)(factor, v, norm);
}

void factor_backward(const BinBlocks& factor, BinBlocks& v) noexcept {
  ODAS_EXPECT(factor.rows() == factor_rows(v.rows()) && factor.bins() == v.bins());
  HWY_DYNAMIC_DISPATCH(Backward)(factor, v);
}

void inner_product(const BinBlocks& a, const BinBlocks& b, BinBlocks& out) noexcept {
  ODAS_EXPECT(a.rows() == b.rows() && a.bins() == b.bins() && out.rows() == 1 && out.bins() == a.bins());
  HWY_DYNAMIC_DISPATCH(Inner)(a, b, out);
}

void column_update(BinBlocks& c, const BinReals& gain, const BinBlocks& x, std::size_t reference) noexcept {
  ODAS_EXPECT(c.rows() == x.rows() && c.bins() == x.bins() && gain.bins() == x.bins());
  ODAS_EXPECT(reference < x.rows());
  HWY_DYNAMIC_DISPATCH(Column)(c, gain, x, reference);
}

}  // namespace odas
#endif
