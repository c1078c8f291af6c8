namespace LabRaytracer;

/// <summary>Elementary functions with the same bits on every machine.</summary>
internal static class Elementary
{
    /// <summary>Sine and cosine of an angle in degrees.</summary>
    public static (double Sin, double Cos) SinCosDegrees(double degrees) => Math.SinCos(degrees * (Math.PI / 180));
}
