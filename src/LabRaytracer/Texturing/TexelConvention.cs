namespace LabRaytracer;

/// <summary>Where texels lie on the axes of texture space.</summary>
public enum TexelConvention
{
    /// <summary>Texel i covers [i/W, (i+1)/W) and its centre is at (i + 1/2)/W. Nearest: floor(W u). The default.</summary>
    Center,

    /// <summary>
    /// The sheet's: x_p = (W - 1) u, texels are nodes, and nearest is the cast of Program 2, <c>(int)((W - 1) u)</c>.
    /// The last column is reached only at u = 1.
    /// </summary>
    Lab,
}
