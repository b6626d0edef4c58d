// The only file that includes OpenCV.
#include "engine/surface/picture_kernel.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace lathelier::surface {
namespace {

cv::Mat viewOf(const Grid& grid)
{
    return {grid.rows, grid.columns, CV_32F, const_cast<float*>(grid.values.data())};
}

/// Gaussian mean with cost independent of its width: computed on block means and interpolated.
cv::Mat wideMean(const cv::Mat& picture, double sigma)
{
    const double factor = std::max(1.0, std::floor(sigma / 6));
    cv::Mat small, mean;
    const cv::Size size(std::max(2, static_cast<int>(std::lround(picture.cols / factor))),
                        std::max(2, static_cast<int>(std::lround(picture.rows / factor))));
    cv::resize(picture, small, size, 0, 0, cv::INTER_AREA);
    cv::GaussianBlur(small, small, {}, sigma / factor, sigma / factor, cv::BORDER_REFLECT);
    cv::resize(small, mean, picture.size(), 0, 0, cv::INTER_LINEAR);
    return mean;
}

Grid resized(const GridView& picture, int columns, int rows)
{
    Grid small(columns, rows);
    cv::Mat out = viewOf(small);
    const cv::Mat source(picture.rows, picture.columns, CV_32F, const_cast<float*>(picture.first),
                         static_cast<std::size_t>(picture.stride) * sizeof(float));
    cv::resize(source, out, out.size(), 0, 0, cv::INTER_AREA);
    return small;
}

Grid flat(const Grid& picture, const Progress& progress)
{
    const double sigma = std::min(picture.columns, picture.rows) / 8.0;
    const cv::Mat source = viewOf(picture);
    constexpr double darkest = 1e-4;  // lower bound of the mean over full scale, avoids division by zero
    Grid result(picture.columns, picture.rows);
    cv::Mat out = viewOf(result);
    cv::Mat ratio;
    cv::divide(source, cv::max(wideMean(source, sigma), darkest), ratio);
    cv::subtract(ratio, 1.0, out);
    progress.report(0.5);
    cv::Mat spread;
    cv::sqrt(cv::max(wideMean(out.mul(out), 2 * sigma), 1e-12), spread);
    cv::divide(out, spread, out);
    progress.report(1);
    return result;
}

Grid remapped(const Grid& picture, const std::vector<std::array<float, 2>>& places, int columns, int rows)
{
    const cv::Mat map(rows, columns, CV_32FC2, const_cast<std::array<float, 2>*>(places.data()));
    Grid result(columns, rows);
    cv::Mat out = viewOf(result);
    cv::remap(viewOf(picture), out, map, cv::noArray(), cv::INTER_LANCZOS4, cv::BORDER_REPLICATE);
    return result;
}

Grid moved(const Grid& picture, const AffineMap& map, int columns, int rows, Interpolation interpolation)
{
    const cv::Matx23d move(map.xx, map.xy, map.x0, map.yx, map.yy, map.y0);
    Grid result(columns, rows);
    cv::Mat out = viewOf(result);
    cv::warpAffine(viewOf(picture), out, move, out.size(),
                   interpolation == Interpolation::Linear ? cv::INTER_LINEAR : cv::INTER_CUBIC, cv::BORDER_CONSTANT, 0);
    return result;
}

int fastSize(int least)
{
    return cv::getOptimalDFTSize(least);
}

Grid power(const Grid& picture)
{
    const int columns = picture.columns, rows = picture.rows;
    cv::Mat plane;
    cv::dft(viewOf(picture), plane, cv::DFT_COMPLEX_OUTPUT);
    Grid result(columns, rows);
    for (int y = 0; y < rows; ++y) {
        const auto* line = plane.ptr<cv::Vec2f>(y);
        float* out = result.row((y + rows / 2) % rows);
        for (int x = 0; x < columns; ++x) {
            const double re = double(line[x][0]), im = double(line[x][1]);
            out[(x + columns / 2) % columns] = static_cast<float>(re * re + im * im);
        }
    }
    return result;
}

Vector shift(const Grid& first, const Grid& second, double& response)
{
    cv::Mat window;
    cv::createHanningWindow(window, {first.columns, first.rows}, CV_32F);
    const cv::Point2d found = cv::phaseCorrelate(viewOf(first), viewOf(second), window, &response);
    return {found.x, found.y};
}

void blur(Grid& picture, double sigma_px)
{
    cv::Mat all = viewOf(picture);
    cv::GaussianBlur(all, all, {}, sigma_px, sigma_px, cv::BORDER_REFLECT);
}

}  // namespace
}  // namespace lathelier::surface

extern "C" {
extern const lathelier::surface::PictureKernel lathelier_picture_kernel;
const lathelier::surface::PictureKernel lathelier_picture_kernel{
    lathelier::surface::resized,  lathelier::surface::flat,  lathelier::surface::remapped, lathelier::surface::moved,
    lathelier::surface::fastSize, lathelier::surface::power, lathelier::surface::shift,    lathelier::surface::blur};
}
