import { describe, expect, it } from 'vitest';
import type { Command, CommandKind } from '../../page/command.ts';
import { rankCommands } from './command.ts';

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

  it('what was used lately comes first among what matches as well', () => {
    const waves = [command('example', 'Sine wave'), command('example', 'Two waves, mixed')];
    expect(titles(rankCommands('wave', waves, ['example Two waves, mixed']))).toEqual([
      'Two waves, mixed',
      'Sine wave',
    ]);
  });

  it('words count, at their beginning before inside; letters here and there only where no word is found', () => {
    const all = [
      command('page', 'Settings, Limits'),
      command('action', 'Restart this page'),
      command('example', 'Smooth a pointer', 'Start and open. Smooths the position of one topic.'),
      command('module', 'smooth-pointer'),
      command('client', 'Sara Mart'),
    ];
    expect(titles(rankCommands('start smooth', all, []))).toEqual(['Smooth a pointer']);
    expect(titles(rankCommands('start', all, []))).toEqual([
      'Smooth a pointer',
      'Restart this page',
    ]);
    expect(titles(rankCommands('stlim', all, []))).toEqual(['Settings, Limits']);
  });

  it('topics are found by the name of the phone and of the value', () => {
    const topic = command('topic', '/5f2c/smart-device/acceleration', 'Mara');
    expect(titles(rankCommands('mara accel', [...commands, topic], []))).toEqual([topic.title]);
  });

  it('services need the word or a slash', () => {
    const all = [
      command('service', 'topic_list', 'Lists topics'),
      command('page', 'Topics'),
      command('page', 'Services'),
      command('topic', '/lab/topic'),
    ];
    expect(titles(rankCommands('topic', all, []))).toEqual(['Topics', '/lab/topic']);
    expect(titles(rankCommands('/topic', all, []))).toEqual(['topic_list', '/lab/topic']);
    expect(titles(rankCommands('service topic', all, []))).toEqual(['topic_list']);
    expect(titles(rankCommands('serv', all, []))).toEqual(['Services']);
  });

  it('publishing on a topic is found by its verb', () => {
    const all = [command('topic', '/lab/light'), command('publish', 'Publish to /lab/light')];
    expect(titles(rankCommands('light', all, []))).toEqual(['/lab/light']);
    expect(titles(rankCommands('pub light', all, []))).toEqual(['Publish to /lab/light']);
  });

  it('says nothing where nothing fits', () => {
    expect(titles(rankCommands('nothing like it', commands, []))).toEqual([]);
  });
});
