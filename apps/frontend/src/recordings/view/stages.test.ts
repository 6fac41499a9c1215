// @vitest-environment happy-dom
import { describe, expect, it } from 'vitest';
import { tracksOf, type Track } from '../timeline/track.ts';
import { sceneTracks, stagesOf } from './stages.ts';

const tracks = (...formats: string[]): Track[] =>
  tracksOf(
    formats.map((format) => ({ topic: `/${format}`, clientId: '', format, records: 1 })),
    1000,
  );
const offered = (all: Track[], hasSession: boolean): string[] =>
  stagesOf(all, hasSession).map(({ text }) => text);

describe('what the pane over the timeline can show', () => {
  it('is what the recording has', () => {
    expect(offered(tracks('double', 'image2D', 'pose3D', 'string'), true)).toEqual([
      'Graph',
      'Plot',
      'Picture',
      '3D',
    ]);
    expect(offered(tracks('double'), false)).toEqual(['Plot']);
    expect(offered(tracks('string'), false)).toEqual(['Graph']);
  });

  it('prefers tracks in space to vectors, which are plots', () => {
    expect(
      sceneTracks(tracks('vector3', 'object2DList', 'double')).map(({ topic }) => topic),
    ).toEqual(['/object2DList', '/vector3']);
  });
});
