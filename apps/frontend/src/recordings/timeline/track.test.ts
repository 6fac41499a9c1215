import { describe, expect, it } from 'vitest';
import { rowsIn, rowsOf, tracksOf } from './track.ts';

const topics = Array.from({ length: 200 }, (_, index) => ({
  topic: `/phone ${index}/acceleration`,
  clientId: 'c',
  clientName: `phone ${index}`,
  format: 'vector3',
  records: 600,
}));

describe('tracks of a recording', () => {
  it('are one for each topic, with all who published it', () => {
    const [track, ...others] = tracksOf(
      [
        { topic: '/a/label', clientId: 'c', clientName: 'Mara', format: 'string', records: 3 },
        { topic: '/a/label', clientId: 'c', clientName: 'Jo', format: 'string', records: 2 },
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

  it('are called by the name of their client', () => {
    const id = '729eaeb0-49d7-451a-8ad1-e61fb4e201c2';
    const topic = `/${id}/smart-device/level`;
    const [track] = tracksOf(
      [{ topic, clientId: id, clientName: 'Mara', format: 'double', records: 1 }],
      1,
    );
    expect(track?.label).toBe('smart-device/level · Mara');
  });

  it('of an unknown format are shown as bytes', () => {
    const [track] = tracksOf(
      [{ topic: '/x', clientId: 'c', clientName: '', format: 'foo.Bar', records: 1 }],
      1,
    );
    expect(track).toMatchObject({ kind: 'bytes', family: 'system', formatText: 'foo.Bar' });
  });

  it('are made only where they can be seen', () => {
    const { rows, heightPx } = rowsOf(tracksOf(topics, 60_000));
    const seen = rowsIn(rows, heightPx / 2, 340);
    expect(seen.length).toBeLessThan(10);
    expect(seen[0]!.topPx).toBeLessThanOrEqual(heightPx / 2);
  });
});
