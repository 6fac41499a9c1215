import { describe, expect, it } from 'vitest';
import type { Command, CommandKind } from '../../page/command.ts';
import { rankCommands, rememberRecent } from './command.ts';

const command = (kind: CommandKind, title: string, detail = ''): Command => ({
  id: `${kind} ${title}`,
  kind,
  title,
  detail,
  run: () => undefined,
});
const titles = (commands: readonly Command[]) => commands.map(({ title }) => title);

describe('rankCommands', () => {
  const commands = [
    command('page', 'Home'),
    command('page', 'Topics'),
    command('action', 'Dark theme'),
    command('client', 'Theo', 'iPhone, Safari'),
    command('topic', '/theo/topics'),
  ];

  it('without a query: recent first, then all that is not a stream or a client', () => {
    expect(titles(rankCommands('', commands, ['action Dark theme', 'topic /theo/topics']))).toEqual(
      ['Dark theme', '/theo/topics', 'Home', 'Topics'],
    );
  });

  it('a page wins against a topic of the same name', () => {
    expect(titles(rankCommands('topics', commands, []))).toEqual(['Topics', '/theo/topics']);
  });

  it('searches details too', () => {
    expect(titles(rankCommands('iphone', commands, []))).toEqual(['Theo']);
  });

  it('what was used lately comes earlier', () => {
    const [first] = rankCommands('the', commands, ['topic /theo/topics']);
    expect(titles([first!])).not.toEqual(['Home']);
    expect(titles(rankCommands('nothing like it', commands, []))).toEqual([]);
  });
});

it('remembers a handful, newest first, each once', () => {
  let recent: string[] = [];
  for (const id of ['a', 'b', 'a', 'c', 'd', 'e', 'f', 'g']) recent = rememberRecent(recent, id);
  expect(recent).toEqual(['g', 'f', 'e', 'd', 'c', 'a']);
});
