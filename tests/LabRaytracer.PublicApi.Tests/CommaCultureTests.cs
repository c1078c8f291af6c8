using System.Globalization;

namespace LabRaytracer.PublicApi.Tests;

/// <summary>A machine that writes 0,5 for a half reads and writes the same files.</summary>
public sealed class CommaCultureTests
{
    [Fact]
    public void SceneSchema_IsTheSame()
    {
        string point = SceneSchema.Generate();
        CultureInfo before = CultureInfo.CurrentCulture;
        CultureInfo comma = (CultureInfo)CultureInfo.InvariantCulture.Clone();
        comma.NumberFormat.NumberDecimalSeparator = ",";
        try
        {
            CultureInfo.CurrentCulture = comma;
            Assert.Equal(point, SceneSchema.Generate());
        }
        finally
        {
            CultureInfo.CurrentCulture = before;
        }
    }
}
