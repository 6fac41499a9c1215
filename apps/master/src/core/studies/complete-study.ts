import { ServiceError, StudyOrder, type Study, type StudyDevice } from '@ubii/proto';
import { labelOf, NameTemplate } from '@ubii/recording/studies';
import type { LimitWatch } from '../counters/limit-watch.ts';
import { quote } from '../texts/quote.ts';

/** Most devices of one kind that a study can require. */
const MAX_COUNT = 1_000;
const ORDERS: readonly number[] = Object.values(StudyOrder);

/** Returns a study as it is kept, without what the master adds. @throws ServiceError when it is invalid or too large [ST-2] [ST-3] */
export function completeStudy(study: Study, watch: LimitWatch): Study {
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
    ...{ earlierConsentTexts: [], participantCount: 0, runCount: 0 },
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
