import { readFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import packageJson from '../package.json' with { type: 'json' };
import { installCommand, sampleFor } from './samples.ts';

const read = (path: string): string => readFileSync(new URL(path, import.meta.url), 'utf8');

it.each(['../../../docs/guides/a-program.md', '../../../README.md', '../README.md'])(
  '%s shows the first program as it is, and installs the library of this version',
  (page) => {
    expect(read(page)).toContain(`\`\`\`js\n${read('../samples/first-program.mjs')}\`\`\``);
    expect(read(page)).toContain(
      `${installCommand('http://localhost:8080', packageJson.version)}\n`,
    );
  },
);

it.each([
  ['first-module.mjs', 'js'],
  ['first-page.html', 'html'],
])('the guide shows %s as it is', (name, language) => {
  expect(read('../../../docs/guides/a-program.md')).toContain(
    `Create \`${name}\`:\n\n\`\`\`${language}\n${read(`../samples/${name}`)}\`\`\``,
  );
});

it('the samples have the address and the token that are given', () => {
  const page = sampleFor(read('../samples/first-page.html'), 'http://10.0.0.5:8080', 'secret');
  expect(page).not.toMatch(/localhost|TOKEN/);
  expect(page).toContain("joinToken: 'secret'");
  expect(page).toContain("from 'http://10.0.0.5:8080/sdk/ubii-client.js'");
});
