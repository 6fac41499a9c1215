import { ClientState } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { nextStatus, wireState, type ClientEvent, type ClientStatus } from './client-states.ts';

const STATUSES: ClientStatus[] = ['active', 'inactive', 'unavailable', 'removed'];

describe('nextStatus', () => {
  it.each<[ClientStatus, ClientEvent, ClientStatus]>([
    ['active', 'silent', 'inactive'],
    ['active', 'socket closed', 'inactive'],
    ['inactive', 'lost', 'unavailable'],
    ['inactive', 'sign', 'active'],
    ['unavailable', 'sign', 'active'],
    ['unavailable', 'expired', 'removed'],
  ])('moves from %s on %s to %s [CL-10]', (status, event, next) => {
    expect(nextStatus(status, event)).toBe(next);
  });

  it.each<[ClientStatus, ClientEvent]>([
    ['active', 'sign'],
    ['active', 'expired'],
    ['inactive', 'silent'],
    ['unavailable', 'socket closed'],
    ['unavailable', 'silent'],
  ])('stays %s on %s [CL-10]', (status, event) => {
    expect(nextStatus(status, event)).toBe(status);
  });

  it('ends with deregistration, from everywhere and permanently [CL-16]', () => {
    for (const status of STATUSES) expect(nextStatus(status, 'deregistered')).toBe('removed');
    expect(nextStatus('removed', 'sign')).toBe('removed');
  });

  it('knows the states of the protocol, in which a removed client is unavailable [CL-31]', () => {
    expect(STATUSES.map(wireState)).toEqual([
      ClientState.ACTIVE,
      ClientState.INACTIVE,
      ClientState.UNAVAILABLE,
      ClientState.UNAVAILABLE,
    ]);
  });
});
