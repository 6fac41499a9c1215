import { AccessRole, AuditEntryWay, type AuditEntry } from '@ubii/proto';
import { expect, it } from 'vitest';
import { deedOf, standingOf, whoOf } from './audit-words.ts';

const entry = (changes: Partial<AuditEntry> = {}): AuditEntry =>
  ({
    number: 1,
    timeMs: 0,
    service: '/services/session/runtime/start',
    object: 'Lights',
    error: '',
    clientId: 'c-1',
    clientName: 'Ben',
    role: AccessRole.ACCESS_ROLE_PARTICIPANT,
    way: AuditEntryWay.GRANT,
    grantId: '12345678-9',
    grantLabel: 'Class 7b',
    addressKind: 0,
    leftOut: 0,
    masterName: '',
    ...changes,
  }) as AuditEntry;

it('an entry is told in words [EX-91]', () => {
  expect(deedOf(entry())).toBe('started the session Lights');
  expect(deedOf(entry({ service: '/services/new/thing', object: '' }))).toBe('called new/thing');
  expect(deedOf(entry({ error: 'not_found' }))).toBe('tried to start the session Lights');
  expect(standingOf(entry())).toBe('participant, invitation Class 7b');
  expect(standingOf(entry({ grantLabel: '' }))).toBe('participant, invitation 12345678');
  expect(standingOf(entry({ grantId: '', role: AccessRole.ACCESS_ROLE_ADMIN }))).toBe('admin');
  expect(standingOf(entry({ masterName: 'Foyer' }))).toBe(
    'participant, invitation Class 7b, through the master Foyer',
  );
});

it('the actor has a name, the beginning of an id, or a kind of access [EX-91]', () => {
  expect(whoOf(entry())).toBe('Ben');
  expect(whoOf(entry({ clientName: '', clientId: '9b2f9c1e-3f0a' }))).toBe('Client 9b2f9c1e');
  const unnamed = { clientName: '', clientId: '', way: AuditEntryWay.LOCAL };
  expect(whoOf(entry(unnamed))).toContain('on the computer of the master');
  const elsewhere = { ...unnamed, way: AuditEntryWay.CLUSTER, masterName: 'Foyer' };
  expect(whoOf(entry(elsewhere))).toBe('A program that called the master Foyer');
});

it('the actor has its display name while its own name is the same [EX-91]', () => {
  expect(whoOf(entry(), { ownName: 'Ben', displayName: 'Ben 2' })).toBe('Ben 2');
  expect(whoOf(entry(), { ownName: 'Ada', displayName: 'Ada' })).toBe('Ben');
  expect(whoOf(entry(), { ownName: undefined, displayName: undefined })).toBe('Ben');
});
