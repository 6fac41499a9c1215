/** What a bridge takes from the other system, and keeps for it, at most. [BR-30] */
export const BRIDGE_LIMITS = {
  /** Characters of a mapping file. */
  mappingFileChars: 1_000_000,
  mappings: 200,
  /** Bytes of one message from the other system, unless a mapping allows less. */
  messageBytes: 4 * 1024 * 1024,
  /** Topics, or addresses of the other system, that a mapping makes, unless it says another number. */
  topicsPerMapping: 1_000,
  mostTopicsPerMapping: 10_000,
  /** Without a value for so long, a topic or address of a full mapping is evicted for a new one. [BR-34] */
  quietMs: 60_000,
  /** Evictions of each direction of a mapping in a second. [BR-34] */
  evictionsPerSecond: 1,
  /** Bytes of a topic [TD-13], and of an address of the other system. */
  addressBytes: 1_024,
  /** Messages of the other system that are looked at in a second, all mappings together. */
  messagesPerSecond: 5_000,
  /** Messages for the other system that wait while it is not connected: the newest of each address. */
  waitingMessages: 1_000,
  waitingBytes: 8 * 1024 * 1024,
  /** Objects and lists within each other in JSON, and all its values. */
  jsonDepth: 32,
  jsonValues: 100_000,
  /** Characters of a value that the report shows. */
  shownChars: 200,
  /** Values that were sent and may come back. */
  rememberedEchoes: 1_000,
  echoMs: 5_000,
} as const;
