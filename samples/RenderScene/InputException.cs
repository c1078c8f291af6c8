namespace RenderScene;

/// <summary>A file or folder that the command needs is not as it should be; the message says what to do.</summary>
/// <param name="message">What is wrong and what to do.</param>
/// <param name="inner">The failure behind it, if any.</param>
internal sealed class InputException(string message, Exception? inner = null) : Exception(message, inner);
