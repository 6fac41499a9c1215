import { ALL_OPTIONS } from './options.ts';
import type { OptionName } from './options.ts';
import { environmentName, flagName } from './read-config.ts';

const LINE_WIDTH = 96;
const INDENT = '      ';

/** Returns the help: each option with its flag, environment variable, default and meaning. */
export function formatHelp(): string {
  const entries = (Object.keys(ALL_OPTIONS) as OptionName[]).map((name) => {
    const { placeholder, fallback, fallbackText, description } = ALL_OPTIONS[name];
    const flag = `  ${flagName(name)}${placeholder === undefined ? '' : ` ${placeholder}`}`;
    const variable = `${environmentName(name)}; default: ${fallbackText ?? String(fallback)}`;
    return [flag, ...wrap(description), ...wrap(variable)].join('\n');
  });
  return [
    'Ubi-Interact node: runs processing modules of the sessions of a master.',
    '',
    '  npm run node -- [flags]',
    '',
    'Each option is a flag and an environment variable. When both are set, the flag applies.',
    '',
    ...entries,
    '',
  ].join('\n');
}

function wrap(text: string): string[] {
  const lines: string[] = [];
  let line = INDENT;
  for (const word of text.split(' ')) {
    if (line.length + word.length > LINE_WIDTH) {
      lines.push(line.trimEnd());
      line = INDENT;
    }
    line += `${word} `;
  }
  return [...lines, line.trimEnd()];
}
