import { resolve } from 'node:path';

import { option, type Option } from './option.ts';

/** From most to least severe. */
export const LOG_LEVELS = ['error', 'warn', 'info', 'debug'] as const;

export type LogLevel = (typeof LOG_LEVELS)[number];

/** @param least the least severe level that is written */
export function isLogged(level: LogLevel, least: LogLevel): boolean {
  return LOG_LEVELS.indexOf(level) <= LOG_LEVELS.indexOf(least);
}

/*
 * Each function reads the text of one option, and throws an Error whose message is the expected value, to follow
 * "must be".
 */

export function parseSwitch(text: string): boolean {
  if (/^(1|true|on|yes)$/i.test(text)) return true;
  if (/^(0|false|off|no|)$/i.test(text)) return false;
  throw new Error('true or false');
}

/** @returns an absolute path */
export function parsePath(text: string, baseDir: string): string {
  if (text === '') throw new Error('a path');
  return resolve(baseDir, text);
}

/** A name that is shown to people, in one line. */
export function parseName(text: string): string {
  const name = text.trim();
  // eslint-disable-next-line no-control-regex -- names are lines that are drawn and logged
  if (name === '' || name.length > 100 || /[\u0000-\u001f\u007f]/.test(name)) {
    throw new Error('1 to 100 characters, without control characters');
  }
  return name;
}

/** Both ends are included. */
export function parseWholeNumber(least: number, most: number): (text: string) => number {
  return (text) => {
    const number = /^\d+$/.test(text) ? Number(text) : Number.NaN;
    if (number >= least && number <= most) return number;
    throw new Error(`a whole number from ${least} to ${most}`);
  };
}

/** Decimal, without an exponent. Both ends are included. */
export function parseNumber(least: number, most: number): (text: string) => number {
  return (text) => {
    const number = /^\d+(\.\d+)?$/.test(text) ? Number(text) : Number.NaN;
    if (number >= least && number <= most) return number;
    throw new Error(`a number from ${least} to ${most}`);
  };
}

const eitherOf = new Intl.ListFormat('en-GB', { type: 'disjunction' });

/** @param choices in lower case; the text may be in upper case */
export function parseChoice<const C extends string>(...choices: readonly C[]): (text: string) => C {
  return (text) => {
    const choice = choices.find((candidate) => candidate === text.toLowerCase());
    if (choice === undefined) throw new Error(eitherOf.format(choices));
    return choice;
  };
}

/** Parts of a text that commas separate, without the spaces around them and without empty ones. */
export function parseList(text: string): readonly string[] {
  return text
    .split(',')
    .map((part) => part.trim())
    .filter((part) => part !== '');
}

/** Origins that requests go to, separated by commas, without wildcards. */
export function parseFetchOrigins(text: string): readonly string[] {
  return parseList(text).map((origin) => {
    const url = URL.canParse(origin) ? new URL(origin) : undefined;
    if (url === undefined || !/^https?:$/.test(url.protocol) || url.pathname !== '/') {
      throw new Error('origins separated by commas, such as https://example.org');
    }
    return url.origin;
  });
}

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
