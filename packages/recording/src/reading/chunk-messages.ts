import { byTime, type StoredMessage } from '../mcap/chunk-content.ts';

/** The messages of a chunk. */
export class ChunkMessages {
  /** By log time. */
  readonly all: readonly StoredMessage[];
  #byChannel: Map<number, StoredMessage[]> | undefined;

  /** @param messages in the order of the file, which those of the same time keep */
  constructor(messages: StoredMessage[]) {
    this.all = messages.sort(byTime);
  }

  /** The last message of a channel that is not later than a moment. */
  latestAt(channelId: number, timeNs: bigint): StoredMessage | undefined {
    this.#byChannel ??= group(this.all);
    const messages = this.#byChannel.get(channelId);
    return messages?.findLast(({ logTimeNs }) => logTimeNs <= timeNs);
  }
}

function group(messages: readonly StoredMessage[]): Map<number, StoredMessage[]> {
  const groups = new Map<number, StoredMessage[]>();
  for (const message of messages) {
    const group = groups.get(message.channelId);
    if (group === undefined) groups.set(message.channelId, [message]);
    else group.push(message);
  }
  return groups;
}
