import { readFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { readMappingFile } from '../src/core/mapping/read-mapping-file.ts';
import type { Protocol } from '../src/core/mapping/mapping.ts';

const guide = readFileSync(new URL('../../../docs/guides/a-bridge.md', import.meta.url), 'utf8');

function fileOf(name: string): string {
  const [, text] = guide.split(`Create \`${name}\`:\n\n\`\`\`json\n`);
  if (text === undefined) throw new Error(`The guide has no file ${name}.`);
  return text.slice(0, text.indexOf('\n```'));
}

it.each([
  ['bridge.json', 'mqtt', 3],
  ['home.json', 'mqtt', 0],
  ['controller.json', 'osc', 2],
  ['robot.json', 'rosbridge', 2],
] as [string, Protocol, number][])(
  '%s of the guide is a mapping file of %s [BR-1]',
  (name, protocol, count) => {
    expect(readMappingFile(fileOf(name), protocol).mappings).toHaveLength(count);
  },
);
