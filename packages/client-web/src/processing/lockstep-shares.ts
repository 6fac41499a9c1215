import type { LockstepProcessingRequest } from '@ubii/proto';
import { TextCache, encodeLockstepReplyFrame, readRecordHead } from '@ubii/proto/wire';
import type { LockstepMessage } from '@ubii/proto/wire';
import type { EncodedRecord, ModuleRuntime, PassReply } from '@ubii/pm-sandbox';

/** Topics and ids come with every pass. */
const texts = new TextCache();

/** Runs this node's share of a lockstep pass and gives the frame that answers it. [SE-40] [PM-27] */
export async function runShare(
  { head, records }: LockstepMessage<LockstepProcessingRequest>,
  runtime: ModuleRuntime | undefined,
): Promise<Uint8Array> {
  const { processingModuleIds, pass, sessionId, deltaTime, deltaTimeMs } = head;
  // Those the node does not have yet, or not any more, are missing in the answer.
  const instanceIds = processingModuleIds.filter((id) => runtime?.has(id) === true);
  const reply: PassReply =
    runtime === undefined || instanceIds.length === 0
      ? { instanceIds: [], records: [] }
      : await runtime.runPass({
          instanceIds,
          deltaTimeMs: deltaTime > 0 ? deltaTime : deltaTimeMs,
          records: records.map(encodedRecord),
        });
  return encodeLockstepReplyFrame(
    { processingModuleIds: [...reply.instanceIds], pass, sessionId },
    reply.records,
  );
}

function encodedRecord(bytes: Uint8Array): EncodedRecord {
  const { topic, valueField, clientId } = readRecordHead(bytes, texts);
  return { topic, bytes, valueField, publisherId: clientId };
}
