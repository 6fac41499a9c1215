import { LOG_LEVELS } from './log-levels.ts';
import { option } from './option.ts';
import type { Option } from './option.ts';
import { parseChoice, parsePath, parseSwitch } from './parse-values.ts';

/** A switch without a value, which is off by default. */
export function switchOption(description: string): Option<boolean> {
  return option({ placeholder: undefined, fallback: false, description, parse: parseSwitch });
}

/** One of some words, in lower or upper case. */
export function choiceOption<const C extends string>(
  choices: readonly C[],
  fallback: C,
  description: string,
): Option<C> {
  const placeholder = choices.join('|');
  return option({ placeholder, fallback, description, parse: parseChoice(...choices) });
}

/** A path of a file or folder. @param fallbackText what the help says about the default, which is no path */
export function pathOption(
  placeholder: string,
  fallbackText: string,
  description: string,
): Option<string | undefined> {
  return option({ placeholder, fallback: undefined, fallbackText, description, parse: parsePath });
}

/** Several values, separated by commas. Default: none */
export function listOption(
  placeholder: string,
  description: string,
  parse: (text: string) => readonly string[],
): Option<readonly string[]> {
  return option({ placeholder, fallback: [], fallbackText: 'none', description, parse });
}

/** The least severe messages of the log. */
export const logLevelOption = choiceOption(LOG_LEVELS, 'info', 'The least severe messages to log.');

/** Options that every program has. They stand at the end of its table. */
export const HELP_OPTIONS = {
  help: switchOption('Show this help and exit.'),
  version: switchOption('Show the version and exit.'),
} as const;
