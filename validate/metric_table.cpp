#include "metric_table.h"

#include <array>

namespace plumbline {
namespace {

constexpr auto kMetrics = std::to_array<MetricInfo>({
    {"silhouette.iou", "1", "1", "pixels that show the object in both frames / in either"},
    {"silhouette.iou_low", "1", "1", "lowest iou that the reference's uncertain pixels leave open"},
    {"silhouette.iou_high", "1", "1", "highest one"},
    {"silhouette.missing_px", "px", "0", "pixels that should show the object and don't"},
    {"silhouette.extra_px", "px", "0", "pixels that show the object and shouldn't"},
    {"silhouette.reference_px", "px", "", "pixels of the object in the reference"},
    {"silhouette.test_px", "px", "", "pixels of the object in the test"},
    {"silhouette.intersection_px", "px", "", "numerator of iou"},
    {"silhouette.union_px", "px", "", "denominator of iou"},
    {"silhouette.uncertain_px", "px", "", "pixels at which the reference can't tell which object is seen"},
    {"depth.domain_px", "px", "", "pixels compared: the same object in both, depth finite in both"},
    {"depth.bias", "world", "0", "mean of e = test - reference; positive: too far away"},
    {"depth.mae", "world", "0", "mean of |e|"},
    {"depth.rmse", "world", "0", "square root of the mean of e squared"},
    {"depth.p50", "world", "0", "median of |e|, nearest rank"},
    {"depth.p95", "world", "0", "95th percentile of |e|, nearest rank"},
    {"depth.p99", "world", "0", "99th percentile of |e|, nearest rank"},
    {"depth.max", "world", "0", "largest |e|"},
    {"depth.bias_relief", "relief depth", "0", "bias / relief depth of the pixel's object"},
    {"depth.mae_relief", "relief depth", "0", "mae likewise"},
    {"depth.rmse_relief", "relief depth", "0", "rmse likewise"},
    {"depth.p50_relief", "relief depth", "0", "p50 likewise"},
    {"depth.p95_relief", "relief depth", "0", "p95 likewise"},
    {"depth.p99_relief", "relief depth", "0", "p99 likewise"},
    {"depth.max_relief", "relief depth", "0", "max likewise"},
    {"depth.badpix_1pct", "1", "0", "share of the domain with |e| above 1 % of the relief depth"},
    {"depth.badpix_5pct", "1", "0", "share above 5 %"},
    {"depth.badpix_25pct", "1", "0", "share above 25 %"},
    {"depth.badpix_1pct_px", "px", "0", "numerator of badpix_1pct"},
    {"depth.badpix_5pct_px", "px", "0", "numerator of badpix_5pct"},
    {"depth.badpix_25pct_px", "px", "0", "numerator of badpix_25pct"},
    {"depth.only_reference_px", "px", "0",
     "pixels only the reference covers with the object: not in the domain"},
    {"depth.only_test_px", "px", "0", "pixels only the test covers with it: not in the domain"},
    {"depth.invalid_px", "px", "0", "shared pixels without a finite depth in both: not in the domain"},
    {"depth.uncertain_px", "px", "", "pixels of the domain that may show another object in truth, or none"},
    {"shadow.domain_px", "px", "", "pixels compared: the same object in both, shadow known in both"},
    {"shadow.agreement", "1", "1", "share of the domain where both are lit or both in shadow"},
    {"shadow.agreement_low", "1", "1", "lowest agreement that the reference's uncertain pixels leave open"},
    {"shadow.agreement_high", "1", "1", "highest one"},
    {"shadow.iou", "1", "1", "in shadow in both / in either"},
    {"shadow.iou_low", "1", "1", "lowest iou that uncertain pixels leave open"},
    {"shadow.iou_high", "1", "1", "highest one"},
    {"shadow.f1", "1", "1", "harmonic mean of the test's precision and recall on shadow"},
    {"shadow.f1_low", "1", "1", "lowest f1 that uncertain pixels leave open"},
    {"shadow.f1_high", "1", "1", "highest one"},
    {"shadow.ber", "1", "0", "balanced error rate: mean of the error rates on lit and on dark pixels"},
    {"shadow.false_shadow_px", "px", "0", "lit in the reference, in shadow in the test"},
    {"shadow.false_lit_px", "px", "0", "in shadow in the reference, lit in the test"},
    {"shadow.both_shadow_px", "px", "", "in shadow in both"},
    {"shadow.both_lit_px", "px", "", "lit in both"},
    {"shadow.invalid_px", "px", "0",
     "shared pixels without a finite shadow value in both: not in the domain"},
    {"shadow.uncertain_px", "px", "",
     "pixels of the test whose shadow in the reference, or part in the domain, is uncertain"},
    {"normal.domain_px", "px", "", "pixels compared: the same object in both, a normal in both"},
    {"normal.mean_degrees", "degrees", "0", "mean angle between the normals"},
    {"normal.p95_degrees", "degrees", "0", "95th percentile of the angle, nearest rank"},
    {"normal.invalid_px", "px", "0", "shared pixels without a normal in both: not in the domain"},
    {"st.domain_px", "px", "", "pixels compared: the same object in both, st finite in both"},
    {"st.mean_texels", "texels", "0", "mean distance in the height map between the places seen"},
    {"st.p95_texels", "texels", "0", "95th percentile of it, nearest rank"},
    {"st.invalid_px", "px", "0", "shared pixels without a finite st in both: not in the domain"},
    {"cost.fetches_mean", "look-ups", "", "height, cone or distance look-ups a covered pixel"},
    {"cost.fetches_p99", "look-ups", "", "99th percentile of it, nearest rank"},
    {"cost.fetches_px", "px", "", "covered pixels counted"},
    {"cost.ms_median", "ms", "", "median time of one frame, warm"},
});

} // namespace

std::span<const MetricInfo> metricTable() {
    return kMetrics;
}

} // namespace plumbline
