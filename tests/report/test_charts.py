"""Charts for print: what is written beside the curves leaves them their room."""

import matplotlib as mpl
import matplotlib.pyplot as plt
from matplotlib.figure import Figure

from sailnet.report.charts import STYLE, Chart, Curve, draw_chart, shown_figure


def drawn(words: int) -> tuple[Figure, float]:
    """A chart with a legend of two labels of so many words, and the width of its axes as a share."""
    label = " ".join(["attitude"] * words)
    curves = [Curve("x", "y", label), Curve("x", "z", f"other {label}")]
    columns = {"x": [0.0, 1.0], "y": [0.0, 1.0], "z": [1.0, 0.0]}
    with mpl.rc_context(STYLE):
        figure = Figure(figsize=(6.4, 4.4), layout="constrained")
        draw_chart(figure.subplots(), Chart("a", "A", "", "time [TU]", "share [%]", curves, columns))
        figure.draw_without_rendering()
    return figure, figure.axes[0].get_position().width


def test_a_long_label_of_the_legend_takes_no_room_of_the_axes() -> None:
    short, long = drawn(1)[1], drawn(9)[1]
    assert short > 0.8
    assert long > 0.95 * short


def test_the_legend_is_below_what_is_written_at_the_axes() -> None:
    figure, _ = drawn(9)
    (axes,) = figure.axes
    legend = axes.get_legend()
    assert legend is not None
    assert legend.get_window_extent().y1 <= axes.xaxis.label.get_window_extent().y0 + 1.0


def test_letters_of_a_notebook_s_figure_are_large_enough_in_its_column() -> None:
    """Of two charts side by side, in 7.5 inches; and the label of an axis keeps within its row."""
    plt.switch_backend("agg")
    label = "λ_r [TU/AU], λ_u, λ_v [TU²/AU]"
    columns = {"x": [0.0, 1.0], "y": [0.0, 1.0]}
    chart = Chart("a", "A", "", "time [TU]", label, [Curve("x", "y")], columns)
    figure = shown_figure([chart] * 4, columns=2)
    assert 10.0 * 7.5 / figure.get_size_inches()[0] > 7.0
    figure.draw_without_rendering()
    assert figure.axes[2].yaxis.label.get_window_extent().height < figure.bbox.height / 2
    plt.close(figure)
