namespace LabRaytracer;

/// <summary>Some rows of the rendered picture.</summary>
/// <param name="Pixels">Their pixels.</param>
/// <param name="Top">Row of the whole picture that is row 0 here.</param>
internal readonly record struct PicturePart(Picture Pixels, int Top);
