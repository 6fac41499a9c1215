/** The ports existing clients look for. */
export interface LegacyPorts {
  readonly services: number;
  readonly topicData: number;
}

/** The fallback of `legacyPorts`: where the original master listens. */
export const ORIGINAL_PORTS: LegacyPorts = { services: 8102, topicData: 8104 };
