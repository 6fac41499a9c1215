import { viewersOf } from '../../topics/viewers/viewers.ts';
import type { TopicViewer } from '../../topics/viewers/topic-viewer.ts';
import type { Track } from '../timeline/track.ts';

/** What the pane over the timeline shows. */
export type Stage = 'graph' | 'plot' | 'picture' | 'scene';

const TEXTS: Readonly<Record<Stage, string>> = {
  graph: 'Graph',
  plot: 'Plot',
  picture: 'Picture',
  scene: '3D',
};

/** The stages that have something to show; always one. */
export function stagesOf(
  tracks: readonly Track[],
  hasSession: boolean,
): { readonly value: Stage; readonly text: string }[] {
  const has: Readonly<Record<Stage, boolean>> = {
    graph: hasSession,
    plot: tracks.some(({ kind }) => kind === 'lines'),
    picture: tracks.some(({ kind }) => kind === 'frames'),
    scene: tracks.some((track) => sceneViewer(track) !== undefined),
  };
  const offered = (Object.keys(TEXTS) as Stage[]).filter((stage) => has[stage]);
  const stages = offered.length === 0 ? (['graph'] as const) : offered;
  return stages.map((value) => ({ value, text: TEXTS[value] }));
}

/** The viewer that draws a track in space or in the plane. */
export function sceneViewer({ format }: Track): TopicViewer | undefined {
  return format && viewersOf(format).find(({ id }) => id === 'space' || id === 'plane');
}

/** Whether a track is drawn so at best: a vector is a plot at best. */
export const isScene = (track: Track): boolean =>
  track.format !== undefined && viewersOf(track.format)[0] === sceneViewer(track);

/** Tracks that can be drawn so, those first that are drawn so at best. */
export function sceneTracks(tracks: readonly Track[]): Track[] {
  const all = tracks.filter((track) => sceneViewer(track) !== undefined);
  return [...all.filter(isScene), ...all.filter((track) => !isScene(track))];
}
