import { SERVICES } from '@ubii/proto';
import { expect, it } from 'vitest';
import { findServices, SERVICE_GROUPS } from './service-groups.ts';

it('every service is in one group', () => {
  const grouped = SERVICE_GROUPS.flatMap(({ services }) => services);
  expect([...grouped].sort()).toEqual(Object.keys(SERVICES).sort());
});

it('services are found by words of their name, their sentence and their group', () => {
  expect(findServices('clients profiles').flatMap(({ services }) => services)).toEqual([
    'clientGetList',
  ]);
  expect(findServices('bridges check')).toMatchObject([
    { title: 'Bridges', services: ['bridgeMappingsCheck'] },
  ]);
  expect(findServices('no such service')).toEqual([]);
});
