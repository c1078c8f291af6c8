namespace LabRaytracer;

/// <summary>What is read of a texture, and how its file's numbers are decoded.</summary>
internal enum TextureUse
{
    /// <summary>Colour: 8-bit files are sRGB by default.</summary>
    Color,

    /// <summary>Numbers: codes are linear by default.</summary>
    Data,

    /// <summary>Alpha in all three channels, [0, 1]; always linear.</summary>
    Alpha,

    /// <summary>Colour times alpha, filtered as the product: texels that cannot be seen do not bleed into their neighbours.</summary>
    Premultiplied,
}
