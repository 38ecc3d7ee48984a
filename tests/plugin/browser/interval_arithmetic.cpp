// A program that must not link for WebAssembly, whose rounding mode never changes.
#include <CGAL/Interval_nt.h>

int main(int argc, char** argv) {
    const CGAL::Interval_nt<false>::Protector rounds_up;
    const CGAL::Interval_nt<false> x(argc + 1.0);
    return (x / CGAL::Interval_nt<false>(3)).is_point() ? 1 : argv == nullptr;
}
