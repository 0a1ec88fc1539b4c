#include "factor/evaluate.hpp"
#include "factor/light_block.hpp"
#include "texunit/exact_math.hpp"

namespace twofold {

CookTorranceTable tabulate(const CookTorrance& material) {
    CookTorranceTable table;
    table.diffuse_over_pi = material.diffuse / exact::pi;
    table.scale = material.specular * cook_torrance_constant(material.constant);
    for (const BeckmannLobe& lobe : material.lobes) {
        if (lobe.weight > 0.0) {
            const double square = lobe.m * lobe.m;
            table.lobes.push_back({exact::log(lobe.weight / square), 1.0 / square});
        }
    }
    for (int c = 0; c < 3; ++c) {
        const double eta = refractive_index(material.f0[c]);
        const double value = eta * eta - 1.0;
        std::size_t k = 0;
        while (k < table.curves && table.index_square_less_1[k] != value) {
            ++k;
        }
        table.index_square_less_1[k] = value;
        table.curve[static_cast<std::size_t>(c)] = k;
        table.curves = k < table.curves ? table.curves : k + 1;
    }
    return table;
}

ModifiedPhongTable tabulate(const ModifiedPhong& material) {
    const double scale = (material.exponent + 2.0) / (2.0 * exact::pi);
    return {material.diffuse / exact::pi, material.specular * scale, material.exponent};
}

}  // namespace twofold
