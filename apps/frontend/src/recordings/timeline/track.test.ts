import { describe, expect, it } from 'vitest';
import { rowsIn, rowsOf, scrollShowing, tracksOf } from './track.ts';

const topics = Array.from({ length: 200 }, (_, index) => ({
  topic: `/phone ${index}/acceleration`,
  clientId: 'c',
  format: 'vector3',
  records: 600,
}));

describe('tracks of a recording', () => {
  it('are one for each topic, with all who published it', () => {
    const [track, ...others] = tracksOf(
      [
        { topic: '/a/label', clientId: 'c', format: 'string', records: 3 },
        { topic: '/a/label', clientId: 'd', format: 'string', records: 2 },
      ],
      1000,
      new Map([
        ['c', 'Mara'],
        ['d', 'Jo'],
      ]),
    );
    expect(others).toEqual([]);
    expect(track).toMatchObject({
      name: 'label',
      owner: 'Mara, Jo',
      records: 5,
      hz: 5,
      kind: 'text',
    });
  });

  it('are called by the client whose id they begin with, whoever publishes', () => {
    const id = '729eaeb0-49d7-451a-8ad1-e61fb4e201c2';
    const topics = [
      { topic: `/${id}/smart-device/level`, clientId: '', format: 'double', records: 1 },
    ];
    const [track] = tracksOf(topics, 1, new Map([[id, 'Mara']]));
    expect(track).toMatchObject({ label: 'level · Mara', owner: 'Mara' });
    const [unnamed] = tracksOf(topics, 1);
    expect(unnamed).toMatchObject({ label: 'level · Client 729eaeb0' });
  });

  it('of a publisher without a name are called by the module that writes them', () => {
    const id = '729eaeb0-49d7-451a-8ad1-e61fb4e201c2';
    const topic = (name: string, clientId: string) => {
      return { topic: name, clientId, format: 'double', records: 1 };
    };
    const writers = new Map([
      ['/energy', 'Classifier'],
      ['/angle', 'Classifier'],
    ]);
    const tracks = tracksOf(
      [topic('/angle', 'robot'), topic('/energy', id), topic('/other', id)],
      1,
      new Map([['robot', 'Robot']]),
      writers,
    );
    expect(tracks.map(({ owner }) => owner)).toEqual(['Robot', 'Classifier', 'Client 729eaeb0']);
  });

  it('of an unknown format are shown as bytes', () => {
    const [track] = tracksOf([{ topic: '/x', clientId: 'c', format: 'foo.Bar', records: 1 }], 1);
    expect(track).toMatchObject({ kind: 'bytes', family: 'system', formatText: 'foo.Bar' });
  });

  it('are made only where they can be seen', () => {
    const { rows, heightPx } = rowsOf(tracksOf(topics, 60_000));
    const seen = rowsIn(rows, heightPx / 2, 340);
    expect(seen.length).toBeLessThan(10);
    expect(seen[0]!.topPx).toBeLessThanOrEqual(heightPx / 2);
  });

  it('are scrolled to only as far as they need', () => {
    const { rows } = rowsOf(tracksOf(topics, 60_000));
    const row = rows[10]!;
    expect(scrollShowing(row, row.topPx - 100, 340)).toBe(row.topPx - 100);
    expect(scrollShowing(row, row.topPx + 20, 340)).toBe(row.topPx);
    expect(scrollShowing(row, 0, 340)).toBe(row.topPx + row.track.heightPx - 340);
  });
});
