import { OPTIONS } from './config.ts';
import type { Option, OptionName } from './config.ts';
import { environmentName, flagName } from './option-names.ts';

const LINE_WIDTH = 96;
const INDENT = '      ';

/** The help: every option with its flag, environment variable, key, default and meaning. */
export function formatHelp(): string {
  const entries = (Object.keys(OPTIONS) as OptionName[]).map((name) => {
    const { placeholder, fallback, fallbackText, description } = OPTIONS[name] as Option<unknown>;
    const flag = `  ${flagName(name)}${placeholder === undefined ? '' : ` ${placeholder}`}`;
    const ways = `${environmentName(name)}, "${name}"; default: ${fallbackText ?? String(fallback)}`;
    return [flag, ...wrap(description), ...wrap(ways)].join('\n');
  });
  return [
    'Ubi-Interact master: the frontend, the services and the topic data on one port.',
    '',
    '  npm start -- [flags]',
    '',
    'Each option is a flag, an environment variable and a key of the config file; the first of',
    'them that is set applies.',
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
