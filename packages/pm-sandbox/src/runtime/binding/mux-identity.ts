import type { PatternCompiler } from '@ubii/patterns';
import { MuxIdentity, UUID_PATTERN, type TopicMux } from '@ubii/proto';
import type { EncodedRecord } from '../../ports/topic-port.ts';

/** Tells the elements of a muxer apart. [PM-43] */
export interface IdentityRule {
  /** From what a record brings with it; undefined when that says nothing. Cheap. */
  ofRecord(record: EncodedRecord): string | undefined;
  /**
   * From the topic, where `ofRecord` says nothing. To be asked once for each topic.
   * @throws MatchBudgetError when matching takes longer than there is time for [PM-71]
   */
  ofTopic(topic: string): string | undefined;
}

// eslint-disable-next-line ubii/no-native-patterns -- our own pattern, linear
const FIRST_UUID = new RegExp(UUID_PATTERN);

const none = (): undefined => undefined;

const DEDUCED: IdentityRule = {
  ofRecord: (record) => record.publisherId || undefined,
  ofTopic: (topic) => FIRST_UUID.exec(topic)?.[0] ?? topic,
};
const CLIENT_ID: IdentityRule = {
  ofRecord: (record) => record.publisherId || undefined,
  ofTopic: none,
};
const DEVICE_ID: IdentityRule = {
  ofRecord: (record) => record.deviceId || undefined,
  ofTopic: none,
};
const TOPIC: IdentityRule = { ofRecord: none, ofTopic: (topic) => topic };

/**
 * The rule of a muxer.
 *
 * @throws Error with the reason when its pattern is refused
 */
export function identityRule(
  mux: Pick<TopicMux, 'identitySource' | 'identityMatchPattern' | 'identityGroup'>,
  patterns: PatternCompiler,
): IdentityRule {
  switch (mux.identitySource) {
    case MuxIdentity.MUX_IDENTITY_CLIENT_ID:
      return CLIENT_ID;
    case MuxIdentity.MUX_IDENTITY_DEVICE_ID:
      return DEVICE_ID;
    case MuxIdentity.MUX_IDENTITY_TOPIC:
      return TOPIC;
    default: {
      if (mux.identityMatchPattern === '') return DEDUCED;
      const pattern = patterns.compile(mux.identityMatchPattern);
      const group = mux.identityGroup;
      return { ofRecord: none, ofTopic: (topic) => pattern.match(topic)?.[group] };
    }
  }
}

/** The identity a rule gives a record; undefined when it has none. [PM-43] */
export function identityOf(rule: IdentityRule, record: EncodedRecord): string | undefined {
  return rule.ofRecord(record) ?? rule.ofTopic(record.topic);
}
