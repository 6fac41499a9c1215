import { environmentName, flagName } from './option.ts';
import type { OptionTable, ProgramOptions } from './option.ts';

const LINE_WIDTH = 96;
const INDENT = '      ';

/** Returns the help: each option with its flag, environment variable, key, default and meaning. */
export function formatHelp({
  options,
  about,
  notes,
  environmentPrefix,
  fileOption,
}: Omit<ProgramOptions<OptionTable>, 'check'>): string {
  const entries = Object.entries(options).map(([name, entry]) => {
    const { placeholder, fallback, fallbackText, description } = entry;
    const flag = `  ${flagName(name)}${placeholder === undefined ? '' : ` ${placeholder}`}`;
    const ways = [
      ...(environmentPrefix === undefined ? [] : [environmentName(environmentPrefix, name)]),
      ...(fileOption === undefined ? [] : [`"${name}"`]),
    ];
    const preset = `default: ${fallbackText ?? String(fallback)}`;
    const last = ways.length === 0 ? preset : `${ways.join(', ')}; ${preset}`;
    return [flag, ...wrap(description), ...wrap(last)].join('\n');
  });
  return [about, ...entries, ...(notes === undefined ? [] : ['', notes]), ''].join('\n');
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
