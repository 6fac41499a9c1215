import { option } from './option.ts';
import { parseChoice, parseSwitch } from './parse-values.ts';
import { LOG_LEVELS } from './log-levels.ts';
import type { LogLevel } from './log-levels.ts';

/** Options that every program has. They stand at the end of its table. */
export const HELP_OPTIONS = {
  help: option({
    placeholder: undefined,
    fallback: false,
    description: 'Show this help and exit.',
    parse: parseSwitch,
  }),
  version: option({
    placeholder: undefined,
    fallback: false,
    description: 'Show the version and exit.',
    parse: parseSwitch,
  }),
} as const;

/** The least severe messages of the log. */
export const logLevelOption = option<LogLevel>({
  placeholder: 'error|warn|info|debug',
  fallback: 'info',
  description: 'The least severe messages to log.',
  parse: parseChoice(...LOG_LEVELS),
});
