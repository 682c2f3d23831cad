"""Pictures of what was computed beside what was published."""
import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402  (the backend first)


def skin_friction(path, curves, title, points=(), lines=()):
    """Cf over x: curves (name, x, cf) of faces as dots, published points (x, cf, name) and lines (x, cf, name)."""
    figure, axes = pyplot.subplots(figsize=(8, 5))
    for x, friction, name in lines:
        axes.plot(x, friction, "k-", linewidth=1, label=name)
    for name, x, friction in curves:
        axes.plot(x, friction, ".", markersize=3, label=name)
    for x, friction, name in points:
        axes.plot([x], [friction], "k+", markersize=14, label=name)
    axes.set_xlabel("x")
    axes.set_ylabel("skin friction coefficient")
    middle = sorted(curves[0][2])[len(curves[0][2]) // 2]
    axes.set_ylim(0, 2.5 * middle)
    axes.set_title(title)
    axes.legend()
    figure.savefig(path, dpi=120, bbox_inches="tight")
    pyplot.close(figure)
    return path


def centre_lines(path, curves, table, title):
    """u over y on x = 0.5 and v over x on y = 0.5: curves (name, places, u, v); table: the published y, u, x, v."""
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(11, 5))
    for name, places, u, v in curves:
        left.plot(u, places, label=name)
        right.plot(places, v, label=name)
    left.plot(table["u"], table["y"], "ko", markersize=4, label="Ghia et al. 1982")
    right.plot(table["x"], table["v"], "ko", markersize=4, label="Ghia et al. 1982")
    left.set_xlabel("u on x = 0.5")
    left.set_ylabel("y")
    right.set_xlabel("x")
    right.set_ylabel("v on y = 0.5")
    left.legend()
    figure.suptitle(title)
    figure.savefig(path, dpi=120, bbox_inches="tight")
    pyplot.close(figure)
    return path
