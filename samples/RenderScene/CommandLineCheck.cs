using System.CommandLine;
using System.CommandLine.Parsing;
using LabRaytracer;

namespace RenderScene;

/// <summary>Refuses command lines with one short sentence and the nearest word that would be right.</summary>
internal static class CommandLineCheck
{
    /// <summary>Checks a parsed command line.</summary>
    /// <exception cref="UsageException">It cannot be used.</exception>
    public static void Check(ParseResult parsed)
    {
        Command command = parsed.CommandResult.Command;
        if (parsed.Tokens.FirstOrDefault(token => token.Type == TokenType.Directive || token.Value.Trim().Length == 0) is { } odd)
        {
            throw Unexpected(odd.Value, command);
        }

        CheckOptions(parsed, command);
        if (parsed.UnmatchedTokens.Count > 0)
        {
            throw Unexpected(parsed.UnmatchedTokens[0], command);
        }

        if (parsed.Errors.Count > 0)
        {
            string message = parsed.Errors[0].Message.Trim().TrimEnd('.');
            throw new UsageException($"{message}. {HelpHint(command)}");
        }
    }

    // The parser takes a misspelt option for the scene's file name, or for the value of the option before it.
    private static void CheckOptions(ParseResult parsed, Command command)
    {
        IEnumerable<Token> beforeDashes = parsed.Tokens.TakeWhile(token => token.Type != TokenType.DoubleDash);
        foreach (Token token in beforeDashes.Where(token => token.Type == TokenType.Argument && LooksLikeOption(token.Value)))
        {
            string name = token.Value.Split('=', ':')[0];
            List<string> known = [.. command.Options.SelectMany(option => option.Aliases.Append(option.Name)).Where(known => known.StartsWith("--", StringComparison.Ordinal))];
            string suggestion = Wording.Suggestion(name, known);
            string rest = suggestion.Length > 0 ? "?" : known.Count > 1 ? $"; allowed: {string.Join(", ", known.Order(StringComparer.Ordinal))}." : "; there are no options here.";
            throw new UsageException($"unknown option '{name}'{suggestion}{rest} {HelpHint(command)}");
        }
    }

    private static bool LooksLikeOption(string word) => word.Length > 1 && word[0] == '-' && !char.IsAsciiDigit(word[1]) && word[1] != '.';

    private static UsageException Unexpected(string word, Command command)
    {
        if (command is not RootCommand)
        {
            return new UsageException($"unexpected word '{word}'. {HelpHint(command)}");
        }

        if (word.EndsWith(".json", StringComparison.OrdinalIgnoreCase))
        {
            return new UsageException($"unknown verb '{word}'; to render this scene: render {word}");
        }

        IEnumerable<string> verbs = command.Subcommands.Select(verb => verb.Name);
        string suggestion = Wording.Suggestion(word, verbs);
        return new UsageException($"unknown verb '{word}'{(suggestion.Length > 0 ? suggestion + "?" : $"; allowed: {string.Join(", ", verbs)}.")} {HelpHint(command)}");
    }

    private static string HelpHint(Command command) => command is RootCommand ? "Try --help." : $"Try {command.Name} --help.";
}
