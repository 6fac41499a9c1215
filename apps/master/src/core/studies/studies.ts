import {
  ServiceError,
  StudyOrder,
  type Study,
  type StudyDevice,
  type StudyCheckList,
  type StudyList,
} from '@ubii/proto';
import { labelOf, NameTemplate } from '@ubii/recording/studies';
import type { Clock } from '@ubii/timing';
import type { LimitWatch } from '../counters/limit-watch.ts';
import { quote } from '../texts/quote.ts';
import type { IdSource } from '../ports/id-source.ts';
import type { StudyChecks } from './study-checks.ts';
import type { StudyNews } from './study-news.ts';
import type { StudyStore } from './study-store.ts';
import type { Turns } from './turns.ts';

/** Most devices of one kind that a study can require. */
const MAX_COUNT = 1_000;
const ORDERS: readonly number[] = Object.values(StudyOrder);

/** Returns a study as it is kept, without what the master adds. @throws ServiceError when it is invalid or too large [ST-2] [ST-3] */
function completeStudy(study: Study, watch: LimitWatch): Study {
  const { name, conditions, devices, order, blockMs } = study;
  const repetitions = Math.max(1, study.repetitions);
  const template = new NameTemplate(study.nameTemplate);
  if (name.trim() === '') throw invalid('name', 'is empty. Name the study');
  if (!ORDERS.includes(order)) throw invalid('order', `is ${order}, which is no order`);
  requireNumber('block_ms', blockMs, 0, watch.limits.recordingMs);
  if (template.uses('study')) requireLabelOf('name', name);
  requireConditions(study, template);
  requireRoom(watch, 'studyConditions', conditions.length, 'conditions of a study');
  requireRoom(watch, 'studyBlocks', conditions.length * repetitions, 'blocks of a run');
  requireRoom(watch, 'studyDevices', devices.length, 'required devices of a study');
  return {
    ...study,
    repetitions,
    settingPatterns: study.settingPatterns.map((each) => each.trim()).filter(Boolean),
    devices: devices.map((device, index) => completeDevice(device, `devices[${index}]`)),
    earlierConsentTexts: [],
    participantCount: 0,
    runCount: 0,
  };
}

function requireConditions({ conditions }: Study, template: NameTemplate): void {
  if (conditions.length === 0) throw invalid('conditions', 'is empty. Add at least one condition');
  const known = new Set<string>();
  for (const [index, { name }] of conditions.entries()) {
    const member = `conditions[${index}].name`;
    if (name.trim() === '') throw invalid(member, 'is empty. Name the condition');
    if (template.uses('condition')) requireLabelOf(member, name);
    const label = (labelOf(name) || name).toLowerCase();
    if (known.has(label)) {
      throw invalid(member, `is ${quote(name)}, which has the letters and digits of another one`);
    }
    known.add(label);
  }
}

function completeDevice(device: StudyDevice, member: string): StudyDevice {
  const { name, topicPattern, dataFormat, tag, minRateHz, minBattery, maxClockErrorMs } = device;
  if (name.trim() === '') throw invalid(`${member}.name`, 'is empty. Name the device');
  const given = [topicPattern, dataFormat, tag].filter((text) => text !== '');
  if (given.length !== 1) {
    throw invalid(
      member,
      `has ${given.length} of topic_pattern, data_format and tag. Set one of them`,
    );
  }
  const count = Math.max(1, device.count);
  requireNumber(`${member}.count`, count, 1, MAX_COUNT);
  requireNumber(`${member}.min_rate_hz`, minRateHz, 0, Number.MAX_VALUE);
  requireNumber(`${member}.min_battery`, minBattery, 0, 1);
  requireNumber(`${member}.max_clock_error_ms`, maxClockErrorMs, 0, Number.MAX_VALUE);
  return { ...device, count };
}

function requireNumber(member: string, value: number, min: number, max: number): void {
  if (value >= min && value <= max) return;
  const range = max === Number.MAX_VALUE ? `at least ${min}` : `from ${min} to ${max}`;
  throw invalid(member, `is ${value}. Set it to a number ${range}`);
}

function requireLabelOf(member: string, name: string): void {
  if (labelOf(name) !== '') return;
  throw invalid(
    member,
    `is ${quote(name)}, without letters from A to Z or digits, but name_template uses them`,
  );
}

function requireRoom(
  watch: LimitWatch,
  limit: 'studyConditions' | 'studyBlocks' | 'studyDevices',
  count: number,
  what: string,
): void {
  const max = watch.limits[limit];
  if (count > max) throw watch.refusal(limit, `more than ${max} ${what}`);
}

function invalid(member: string, what: string): ServiceError {
  return new ServiceError('invalid_argument', `The member ${member} of the study ${what}.`);
}

/** What studies work with. */
interface StudiesContext {
  readonly clock: Clock;
  readonly ids: IdSource;
  readonly limits: LimitWatch;
  readonly store: StudyStore;
  readonly checks: StudyChecks;
  readonly news: StudyNews;
  readonly turns: Turns;
}

/** Studies of the master. [ST-1] to [ST-4] */
export class Studies {
  readonly #context: StudiesContext;

  constructor(context: StudiesContext) {
    this.#context = context;
  }

  /** @param isWanted whether studies of this maker are listed [ST-5] */
  list(isWanted: (makerId: string) => boolean): StudyList {
    const { store } = this.#context;
    const studies = store.studies().filter(({ id }) => isWanted(store.makerOf(id)));
    const elements = studies.map((study) => ({
      ...this.#counted(study),
      notes: '',
      consentText: '',
      earlierConsentTexts: [],
    }));
    return { elements };
  }

  get(id: string): Study {
    return this.#counted(this.#context.store.require(id));
  }

  /** Whose a study is. [ST-5] @throws ServiceError when there is none of this id */
  makerOf(id: string): string {
    const { store } = this.#context;
    return store.makerOf(store.require(id).id);
  }

  /** Name of a study, for the audit log; its id when there is none. */
  nameOf(id: string): string {
    return this.#context.store.find(id)?.name ?? id;
  }

  /** [ST-3] @param makerId of a new study */
  save(wanted: Study, makerId: string): Promise<Study> {
    const { store, turns, news, limits, ids, clock } = this.#context;
    const study = completeStudy(wanted, limits);
    return turns.run(async () => {
      const known = wanted.id === '' ? undefined : store.require(wanted.id);
      requireRevision(wanted, known);
      const id = known?.id ?? ids.uuid();
      const kept = { ...study, id, revision: wanted.revision + 1, changedMs: clock.nowMs() };
      await store.save({ ...kept, ...this.#consentOf(study, known) }, makerId);
      news.announce();
      return this.get(id);
    });
  }

  /** [ST-4] */
  delete(id: string): Promise<void> {
    const { store, turns, news, checks } = this.#context;
    return turns.run(async () => {
      const study = this.#counted(store.require(id));
      if (study.participantCount > 0) {
        throw new ServiceError(
          'failed_precondition',
          `The study ${quote(study.name)} has participants. Delete them first.`,
        );
      }
      await store.delete(id);
      checks.forget(id);
      news.announce();
    });
  }

  /** Checks required devices now, and for some time from now on. [ST-32] */
  async check(id: string): Promise<StudyCheckList> {
    const { store, checks, news } = this.#context;
    const study = store.require(id);
    checks.want(id);
    news.announce();
    return checks.checkNow(study);
  }

  #counted(study: Study): Study {
    const runs = this.#context.store.runs(study.id);
    const codes = new Set(runs.map(({ participantCode }) => participantCode));
    return { ...study, participantCount: codes.size, runCount: runs.length };
  }

  /** The version of the consent text, and the earlier ones that participants consented to. [ST-22] */
  #consentOf(
    { consentText }: Study,
    known: Study | undefined,
  ): Pick<Study, 'consentVersion' | 'earlierConsentTexts'> {
    const { store, limits } = this.#context;
    const version = known?.consentVersion ?? 0;
    const texts = known?.earlierConsentTexts ?? [];
    if (known?.consentText === consentText || (known === undefined && consentText === '')) {
      return { consentVersion: version, earlierConsentTexts: texts };
    }
    const consented = new Set(store.runs(known?.id).map(({ consent }) => consent?.version));
    const all = known === undefined ? [] : [...texts, { version, text: known.consentText }];
    const earlierConsentTexts = all.filter((each) => consented.has(each.version));
    const max = limits.limits.studyConsentTexts;
    if (earlierConsentTexts.length > max) {
      const text = `more than ${max} earlier consent texts of a study`;
      throw limits.refusal('studyConsentTexts', text);
    }
    return { consentVersion: version + 1, earlierConsentTexts };
  }
}

/** @throws ServiceError when another revision was changed [ST-3] */
function requireRevision({ revision }: Study, known: Study | undefined): void {
  const expected = known?.revision ?? 0;
  if (revision === expected) return;
  throw new ServiceError(
    'failed_precondition',
    known === undefined
      ? `The member revision is ${revision}, but a new study has 0.`
      : `The study ${quote(known.name)} is at revision ${expected}, but revision ${revision} was changed: another client has changed it since. Get it, and make the change again.`,
  );
}
