namespace Exercises;

/// <summary>Exercise 4: texels outside the picture.</summary>
public static class WrapExercise
{
    /// <summary>The picture is repeated: which texel of a row of <paramref name="size"/> is shown at <paramref name="texel"/>, any integer? Texel -1 is the last one.</summary>
    public static int Repeat(int texel, int size) => throw new NotImplementedException($"Exercise 4: texel {texel} of {size}.");
}
