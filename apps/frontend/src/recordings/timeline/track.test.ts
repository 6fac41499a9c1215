import { describe, expect, it } from 'vitest';
import { rowsIn, rowsOf, tracksOf } from './track.ts';

const topics = Array.from({ length: 200 }, (_, index) => ({
  topic: `/phone ${index}/acceleration`,
  clientName: `phone ${index}`,
  format: 'vector3',
  records: 600,
}));

describe('tracks of a recording', () => {
  it('are one for each topic, with all who published it', () => {
    const [track, ...others] = tracksOf(
      [
        { topic: '/a/label', clientName: 'Mara', format: 'string', records: 3 },
        { topic: '/a/label', clientName: 'Jo', format: 'string', records: 2 },
      ],
      1000,
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

  it('of an unknown format are shown as bytes', () => {
    const [track] = tracksOf([{ topic: '/x', clientName: '', format: 'foo.Bar', records: 1 }], 1);
    expect(track).toMatchObject({ kind: 'bytes', family: 'system', formatText: 'foo.Bar' });
  });

  it('are made only where they can be seen', () => {
    const { rows, heightPx } = rowsOf(tracksOf(topics, 60_000));
    const seen = rowsIn(rows, heightPx / 2, 340);
    expect(seen.length).toBeLessThan(10);
    expect(seen[0]!.topPx).toBeLessThanOrEqual(heightPx / 2);
  });
});
