import type { TurnSource } from './choose-source.ts';

/** Returns the source of the rotation, and how to rotate the model. */
export function viewerInvitation(viewer: {
  readonly source: Pick<TurnSource, 'name' | 'isPhone'> | undefined;
  /** The user of this browser rotates the model. */
  readonly isOwn: boolean;
  readonly hasTurn: boolean;
  /** Names of phones that publish no orientation. */
  readonly silent: readonly string[];
  readonly hasPhone: boolean;
}): string {
  const { source, isOwn, hasTurn, silent, hasPhone } = viewer;
  if (!hasPhone) return 'Drag to rotate the model, or connect a phone and rotate the phone.';
  const name = source?.name ?? 'No client';
  if (!isOwn && !hasTurn) {
    return `${name} publishes no motion. Drag to rotate the model, or allow motion on the phone.`;
  }
  if (!isOwn) return `Rotated by ${name}. Drag to rotate the model by hand.`;
  const [first] = silent;
  return first === undefined
    ? 'Drag to rotate the model.'
    : `Drag to rotate the model. ${first} publishes no motion: allow motion on the phone to rotate the model with it.`;
}
