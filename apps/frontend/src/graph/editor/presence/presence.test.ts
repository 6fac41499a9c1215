import { describe, expect, it } from 'vitest';
import { clientOfPresence, presenceTopic } from '../../../topics/names/presence-topic.ts';
import { PRESENCE_AGE_MS, PresenceBoard } from './presence-board.ts';
import { MAX_NODES, parsePresence, presenceText, type PresenceRecord } from './presence-record.ts';

const record = (changes: Partial<PresenceRecord> = {}): PresenceRecord => ({
  session: 'session',
  nodes: [],
  isEditing: false,
  isHidden: false,
  savedRevision: -1,
  ...changes,
});
const boardOf = (): PresenceBoard => new PresenceBoard('session', () => 'me');
const ids = (board: PresenceBoard): string[] => board.list.map(({ clientId }) => clientId);

describe('the record of an editor [EX-49]', () => {
  it('says all that is known of it', () => {
    const full = record({ nodes: ['topic:/a'], isEditing: true, isHidden: true, savedRevision: 4 });
    expect(parsePresence(presenceText(full))).toEqual(full);
    expect(parsePresence(presenceText(record()))).toEqual(record());
  });

  it('is short, however much is selected', () => {
    const nodes = Array.from({ length: 1000 }, (_, index) => `module:${index}`);
    expect(parsePresence(presenceText(record({ nodes })))?.nodes).toHaveLength(MAX_NODES);
  });

  it('ignores invalid records, because any client may publish there', () => {
    const texts = ['', 'null', '{', '[]', '{"session":1}', `{"session":"${'x'.repeat(20_000)}"}`];
    for (const text of texts) expect(parsePresence(text), text).toBeUndefined();
    expect(parsePresence('{"session":"a","nodes":[1,"b",null],"saved":"x"}')).toEqual(
      record({ session: 'a', nodes: ['b'] }),
    );
  });

  it('belongs to the client of its topic', () => {
    expect(clientOfPresence(presenceTopic('anna'))).toBe('anna');
    expect(clientOfPresence('/anna/graph_editor/presence/more')).toBeUndefined();
    expect(clientOfPresence('/anna/other/presence')).toBeUndefined();
  });
});

describe('other clients with the session open [EX-49]', () => {
  it('reports clients that open and close it', () => {
    const board = boardOf();
    const topic = presenceTopic('anna');
    expect(board.hear(topic, presenceText(record()), 0).arrived).toEqual(['anna']);
    expect(board.hear(topic, presenceText(record({ nodes: ['a'] })), 1).arrived).toEqual([]);
    expect(board.list[0]?.nodes).toEqual(['a']);
    expect(board.hear(topic, presenceText(record({ session: '' })), 2).left).toEqual(['anna']);
    expect(ids(board)).toEqual([]);
  });

  it('counts neither this one nor those who have another session open', () => {
    const board = boardOf();
    board.hear(presenceTopic('me'), presenceText(record()), 0);
    board.hear(presenceTopic('ben'), presenceText(record({ session: 'other' })), 0);
    board.hear('/ben/other/presence', presenceText(record()), 0);
    expect(ids(board)).toEqual([]);
  });

  it('forgets silent clients, but keeps hidden ones', () => {
    const board = boardOf();
    board.hear(presenceTopic('anna'), presenceText(record()), 0);
    board.hear(presenceTopic('ben'), presenceText(record({ isHidden: true })), 0);
    board.hear(presenceTopic('cleo'), presenceText(record()), PRESENCE_AGE_MS);
    expect(board.expire(PRESENCE_AGE_MS + 1).left).toEqual(['anna']);
    expect(ids(board)).toEqual(['ben', 'cleo']);
    expect(board.drop('ben', 'unknown').left).toEqual(['ben']);
  });
});
