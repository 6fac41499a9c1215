import { RecordingKind, type TextLimits } from '@ubii/proto';
import { boundFacts } from './bound-facts.ts';
import { factsOf, type FileFacts } from './file-facts.ts';
import type { RecordingJob } from './recorder.ts';

/**
 * What is kept of what an uploaded file says of itself. What the recording belongs to is not: of the recording of a node,
 * the master knows it; another file belongs to nothing, unless an admin brings back what was part of a study.
 * [RC-41] [RC-63]
 */
export function adoptedFacts(
  job: RecordingJob,
  said: FileFacts,
  nowMs: number,
  limits: TextLimits,
): FileFacts {
  if (job.isOfNode === true) {
    const { author, makerId, study, replayedRecordingId = '' } = job;
    const isComparison = replayedRecordingId !== '';
    const kind = isComparison
      ? RecordingKind.RECORDING_KIND_COMPARISON
      : RecordingKind.RECORDING_KIND_RECORDING;
    const ordered = { author, makerId, study, replayedRecordingId, kind };
    return boundFacts({ ...said, ...ordered }, limits);
  }
  const { notes, personalData } = said;
  const study = job.keepsStudy === true ? said.study : undefined;
  const kept = { ...job, name: job.name || said.name, notes, personalData, study };
  return boundFacts(factsOf(kept, RecordingKind.RECORDING_KIND_IMPORT, nowMs), limits);
}
