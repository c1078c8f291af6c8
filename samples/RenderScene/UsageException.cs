namespace RenderScene;

/// <summary>The command line cannot be used; the message says what is allowed.</summary>
/// <param name="message">What is wrong and what would be right, on one line.</param>
internal sealed class UsageException(string message) : Exception(message);
