import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import type { Game } from '../game.ts';
import { templateGame } from './template-game.ts';

const read = (file: string): string => readFileSync(join(import.meta.dirname, file), 'utf8').trim();
const guide = read('../../../GUIDE.md');

test('guide shows the template as it is, and no other TypeScript', () => {
  expect(guide).toContain(`\`\`\`ts\n${read('template-game.ts')}\n\`\`\``);
  expect(guide.match(/^```(ts|typescript|js)/gm)).toHaveLength(1);
});

test('guide explains every member that the template has', () => {
  const game: Game<never> = templateGame as never;
  const members = Object.keys(game).filter((member) => !['id', 'title'].includes(member));
  for (const member of members) expect(guide).toContain(`| \`${member}\``);
});

test.each([
  ['template', ['template-game.ts']],
  ['quiz', ['../quiz/quiz-game.ts', '../quiz/statements.ts']],
])('%s has less than 200 lines', (_, files) => {
  const lines = files.reduce((sum, file) => sum + read(file).split('\n').length, 0);
  expect(lines).toBeLessThan(200);
});
