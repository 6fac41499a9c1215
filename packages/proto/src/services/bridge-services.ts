import { withPayload } from './define-service.ts';

/** Services on the mappings of bridges. [BR-80] to [BR-82] */
export const BRIDGE_SERVICES = {
  bridgeMappingsGet: withPayload(
    '/services/ubii/bridge_mappings_get',
    'bridgeMappingsRequest',
    'bridgeMappings',
    'Returns the mappings of a bridge.',
  ),
  bridgeMappingsCheck: withPayload(
    '/services/ubii/bridge_mappings_check',
    'bridgeMappingsChange',
    'bridgeMappings',
    'Checks mappings for a bridge without saving them, and lists what one of them selects.',
  ),
  bridgeMappingsSet: withPayload(
    '/services/ubii/bridge_mappings_set',
    'bridgeMappingsChange',
    'bridgeMappings',
    'Replaces the mappings of a bridge, and saves them in its mapping file.',
  ),
} as const;
