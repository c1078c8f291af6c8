using System.Globalization;
using LabRaytracer;

namespace RenderScene;

/// <summary>Figures 3 and 7: pictures in texture space.</summary>
internal static class PlaneFigures
{
    /// <summary>Figure 3: the axes of texture coordinates (u, v) and of texels (x_p, y_p) of a picture of 8 x 4 texels.</summary>
    public static Picture Axes(FigureTools tools)
    {
        const int Columns = 8, Rows = 4;
        Texture texture = Texture.Load(SampleScenes.File("textures/test-8x4.png")).With(new SamplingOptions { Filter = TextureFilter.Nearest });
        int cell = tools.Scaled(110), left = (tools.Width - (Columns * cell)) / 2, top = tools.Scaled(70), bottom = top + (Rows * cell), size = tools.Scaled(17);
        Canvas canvas = new(tools.Width, bottom + tools.Scaled(130), FigureTools.Paper);
        canvas.Flat(texture, left, top, Columns * cell, Rows * cell);
        canvas.Frame(left, top, Columns * cell, Rows * cell);
        for (int x = 0; x < Columns; x++)
        {
            double at = left + (x * Columns * cell / (Columns - 1.0));
            canvas.Line(at, bottom, at, bottom + tools.Scaled(8));
            canvas.Label(x.ToString(CultureInfo.InvariantCulture), at, bottom + tools.Scaled(32), size);
        }

        for (int y = 0; y < Rows; y++)
        {
            double at = bottom - (y * Rows * cell / (Rows - 1.0));
            canvas.Line(left, at, left - tools.Scaled(8), at);
            canvas.Label(y.ToString(CultureInfo.InvariantCulture), left - tools.Scaled(24), at + (size / 2.0), size);
        }

        canvas.Label("x_p = 7u", left + (Columns * cell) + tools.Scaled(110), bottom + tools.Scaled(32), size);
        canvas.Label("y_p = 3v", left - tools.Scaled(100), top - tools.Scaled(12), size);
        DrawCoordinateAxes(canvas, tools, (left, bottom), (Columns * cell, Rows * cell));
        (double x0, double y0) = (left + (0.4 * Columns * cell), bottom - (0.36 * Rows * cell));
        canvas.Ink = Intensity.Black;
        canvas.Line(x0, bottom, x0, y0, 2);
        canvas.Line(left, y0, x0, y0, 2);
        canvas.Dot(x0, y0, tools.Scaled(12));
        canvas.Label("(u,v) = (0.4, 0.36)", x0 + tools.Scaled(180), y0 - tools.Scaled(14), size);
        canvas.Label("(x_p,y_p) = (2.8, 1.08)", x0 + tools.Scaled(200), y0 + tools.Scaled(32), size);
        return canvas.Picture;
    }

    /// <summary>Figure 7: the grid for covering a sphere.</summary>
    public static Picture Grid(FigureTools tools)
    {
        int margin = tools.Scaled(60), width = tools.Width - (2 * margin), height = width / 2;
        Canvas canvas = new(tools.Width, height + (2 * margin), FigureTools.Paper);
        canvas.Flat(new GridTexture(), margin, margin, width, height);
        DrawCoordinateAxes(canvas, tools, (margin, margin + height), (width, height));
        return canvas.Picture;
    }

    /// <summary>Arrows along the lower and left edge, with u and v at their ends.</summary>
    private static void DrawCoordinateAxes(Canvas canvas, FigureTools tools, (int X, int Y) origin, (int Width, int Height) size)
    {
        double beyond = tools.Scaled(32), text = tools.Scaled(20);
        canvas.Ink = new Intensity(0.6f, 0.02f, 0.02f);
        canvas.Arrow(origin.X, origin.Y, origin.X + size.Width + beyond, origin.Y, tools.Scaled(3));
        canvas.Label("u", origin.X + size.Width + beyond + tools.Scaled(12), origin.Y - tools.Scaled(4), text);
        canvas.Ink = new Intensity(0.02f, 0.1f, 0.6f);
        canvas.Arrow(origin.X, origin.Y, origin.X, origin.Y - size.Height - beyond, tools.Scaled(3));
        canvas.Label("v", origin.X + tools.Scaled(20), origin.Y - size.Height - beyond + tools.Scaled(14), text);
        canvas.Ink = new Intensity(0.01f, 0.012f, 0.02f);
    }
}
