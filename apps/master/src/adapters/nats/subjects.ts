/** Ids of masters are UUIDs; nothing else becomes a part of a subject. */
const UUID = /^[0-9a-f]{8}(-[0-9a-f]{4}){3}-[0-9a-f]{12}$/;

/** Masters whose subjects are kept. */
const MAX_KNOWN = 1_000;

export function isMasterId(text: string): boolean {
  return UUID.test(text);
}

/** Subjects of the messages between masters, `ubii.<cluster>.…`. [CU-50] */
export class BusSubjects {
  readonly #cluster: string;
  readonly #own: string;
  readonly #to = new Map<string, string>();
  /** Senders by the subject of what they sent. */
  readonly #senders = new Map<string, string>();
  /** What others send to this master. */
  readonly forOwn: string;
  /** What others send to every master. */
  readonly forAll: string;
  readonly toAll: string;

  /** @param masterId of the master that sends */
  constructor(cluster: string, masterId: string) {
    this.#cluster = cluster;
    this.#own = masterId;
    this.forOwn = `ubii.${cluster}.to.${masterId}.*`;
    this.forAll = `ubii.${cluster}.all.*`;
    this.toAll = `ubii.${cluster}.all.${masterId}`;
  }

  /** @returns undefined when that is no id of a master */
  to(receiver: string): string | undefined {
    const known = this.#to.get(receiver);
    if (known !== undefined || !isMasterId(receiver)) return known;
    // Masters come and go with new ids.
    if (this.#to.size >= MAX_KNOWN) this.#to.clear();
    const subject = `ubii.${this.#cluster}.to.${receiver}.${this.#own}`;
    this.#to.set(receiver, subject);
    return subject;
  }

  /** @returns the id of the master that sent to this subject; undefined when no master did */
  senderOf(subject: string): string | undefined {
    const known = this.#senders.get(subject);
    if (known !== undefined) return known;
    const sender = subject.slice(subject.lastIndexOf('.') + 1);
    if (!isMasterId(sender)) return undefined;
    if (this.#senders.size >= MAX_KNOWN) this.#senders.clear();
    this.#senders.set(subject, sender);
    return sender;
  }
}
