import { describe, expect, it } from 'vitest';
import { topicOptionsOf } from './topic-options.ts';

const MARA = '2fb1c6a2-9d0f-4c8e-8a3b-0f6f3c2e9d11';
const JO = '729eaeb0-49d7-451a-8ad1-e61fb4e201c2';

describe('topics that can be recorded', () => {
  it('[RC-12] are none of the master or of pages, those of a client together', () => {
    const topics = [
      ...['/info/device/new', '/ubii/recordings', `/${JO}/page_state`, `/${JO}/pad/level`],
      ...[`/${MARA}/pad/level`, `${JO}/orientation`, '/lab/x'],
    ];
    const names = new Map([
      [MARA, 'Mara'],
      [JO, 'Jo'],
    ]);
    const options = topicOptionsOf(
      topics.map((topic) => ({ topic, dataFormat: 'double' })),
      (id) => names.get(id),
    );
    expect(options.map(({ text }) => text)).toEqual([
      ...['level · Mara', 'orientation · Jo', 'level · Jo', '/lab/x'],
    ]);
    expect(options[1]).toMatchObject({ value: `${JO}/orientation`, detail: 'double' });
  });
});
