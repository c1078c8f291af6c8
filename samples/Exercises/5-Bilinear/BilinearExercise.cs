namespace Exercises;

/// <summary>Exercise 5: colours between texels.</summary>
public static class BilinearExercise
{
    /// <summary>
    /// The sheet's x_p = (h_res - 1) u, y_p = (v_res - 1) v are real numbers: mix the four texels around (x_p, y_p), each the more the nearer it is.
    /// u and v are in [0, 1], both ends included; stay inside the array.
    /// </summary>
    public static Intensity Sample(Texture texture, double u, double v) =>
        throw new NotImplementedException($"Exercise 5: colour of a texture of {texture.Width} x {texture.Height} at ({u}, {v}).");
}
