import type { Recording } from '@ubii/proto';

/** Names a recording as it is now: another size, another preview. */
export const previewKey = ({ id, sizeBytes }: Pick<Recording, 'id' | 'sizeBytes'>): string =>
  `${id} ${sizeBytes}`;
