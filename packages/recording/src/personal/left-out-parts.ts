import { counted } from '@ubii/words';
import type { RecordingSummary } from '../records/recording-summary.ts';

/** Says which parts of other programs a shared copy leaves out, such as `2 attachments of other programs`; empty for none. [PD-14] */
export function leftOutParts({ foreignParts }: Pick<RecordingSummary, 'foreignParts'>): string {
  const { attachments, metadata } = foreignParts;
  const parts = [
    attachments.length > 0 ? counted(attachments.length, 'attachment') : '',
    metadata.length > 0 ? counted(metadata.length, 'metadata record') : '',
  ].filter(Boolean);
  return parts.length === 0 ? '' : `${parts.join(' and ')} of other programs`;
}
