namespace RenderScene;

/// <summary>One way to render a scene: how long it takes, how far it is from the converged picture.</summary>
/// <param name="Series">What is alike in several points, such as the filter.</param>
/// <param name="Variant">What differs, such as the number of samples.</param>
/// <param name="Seconds">Least time of the picture path, one thread.</param>
/// <param name="Rmse">Root mean square error of linear light, over all pixels and components.</param>
/// <param name="InnerRmse">The same over pixels inside objects, where textures alone make the error; see <see cref="InnerPixels"/>.</param>
internal sealed record FrontierPoint(string Series, string Variant, double Seconds, double Rmse, double InnerRmse);
