import { describe, expect, it } from 'vitest';
import { aSession } from '../../../sessions/testing/a-session.ts';
import { addSession } from '../../model/add-session.ts';
import { graphNews } from '../../model/changes/graph-news.ts';
import { applyCommand } from '../../model/commands/apply-command.ts';
import type { GraphCommand } from '../../model/commands/graph-command.ts';
import { graphOf } from '../../model/graph-of.ts';
import { topicNode } from '../../model/make-node.ts';
import { livePointer } from '../templates/pointer-topics.ts';
import { withPointer } from '../templates/with-pointer.ts';
import { conflictValue } from './conflict-value.ts';

const before = graphOf(aSession());
const newsOf = (command: GraphCommand): string[] =>
  graphNews(before, applyCommand(before, command).graph).map(({ words }) => words);

describe('changes of a user', () => {
  it('is said in words', () => {
    expect(newsOf({ kind: 'add', nodes: [topicNode('/b')] })).toEqual(['added /b']);
    expect(newsOf({ kind: 'remove', nodes: ['module:module'] })).toEqual(['deleted mirror']);
    expect(newsOf({ kind: 'setDetails', changes: { name: 'Other' } })).toEqual([
      'renamed the session to Other',
    ]);
    const mode = { processingMode: { frequency: { hertz: 5 } } };
    expect(newsOf({ kind: 'setModule', node: 'module:module', changes: mode })).toEqual([
      'changed mirror',
    ]);
  });

  it('names moves only when nothing else is different', () => {
    const move = { kind: 'move', positions: new Map([['module:module', { x: 1, y: 2 }]]) } as const;
    expect(newsOf(move)).toEqual(['moved mirror']);
    const both = {
      kind: 'all',
      label: '',
      commands: [move, { kind: 'add', nodes: [topicNode('/b')] }],
    } as const;
    expect(newsOf(both)).toEqual(['added /b']);
    expect(graphNews(before, before)).toEqual([]);
  });
});

it('shows a side of a conflict on a button', () => {
  expect(conflictValue(undefined)).toBe('deleted');
  expect(conflictValue('')).toBe('empty');
  expect(conflictValue({ frequency: { hertz: 5 } })).toBe('5 Hz');
  expect(conflictValue('x'.repeat(100))).toHaveLength(60);
});

describe('a session that is added to a graph', () => {
  let count = 0;
  const options = {
    uuid: () => `uuid-${(count += 1)}`,
    position: { x: 40, y: 40 },
    sizeOf: () => ({ width: 100, height: 50 }),
    label: 'Add it',
  };

  it('comes in one step, with modules of its own and the same topics', () => {
    const added = addSession(before, aSession(), options);
    if (added.kind === 'broken') throw new Error(added.reason);
    const { graph } = applyCommand(before, added.command);
    const modules = [...graph.nodes.values()].filter(({ kind }) => kind === 'module');
    expect(modules).toHaveLength(2);
    expect([...graph.nodes.values()].filter(({ kind }) => kind === 'topic')).toHaveLength(
      [...before.nodes.values()].filter(({ kind }) => kind === 'topic').length,
    );
    expect(graph.wires.size).toBe(2 * before.wires.size);
  });

  it('takes a live pointer: one that moves, then its own; on phones its own alone', () => {
    const format = 'vector2';
    const pointer = (id: string) => `/${id}/web-example-mouse-pointer/mouse_client_position`;
    const topics = [
      { topic: '/x/other', format, hz: 60 },
      { topic: pointer('me'), format, hz: 0 },
      { topic: pointer('anna'), format, hz: 0 },
      { topic: '/ben/web-interface-smart-device/touch_position', format, hz: 30 },
    ];
    expect(livePointer(topics, 'me')).toBe('/ben/web-interface-smart-device/touch_position');
    expect(livePointer(topics.slice(0, 3), 'me')).toBe(pointer('me'));
    expect(livePointer(topics, 'me', true)).toBe(pointer('me'));
    expect(livePointer(topics.slice(2), 'me', true)).toBeUndefined();
    expect(livePointer(topics.slice(0, 1), 'me')).toBeUndefined();
    const session = withPointer(aSession(), '/a/position', '/mine');
    expect(session.ioMappings[0]?.inputMappings[0]?.topic).toBe('/mine');
  });
});
