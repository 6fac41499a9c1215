import { withoutPayload, withPayload } from './define-service.ts';

/** Services for those who run a master: who takes what of it, and what is to be done about it. [EX-25] */
export const OPERATION_SERVICES = {
  clientReport: withPayload(
    '/services/ubii/client_report',
    'clientReportRequest',
    'clientReport',
    'Returns the activity of clients: rates, queues, drops, subscriptions and their share of the work.',
  ),
  clientRename: withPayload(
    '/services/ubii/client_rename',
    'clientRenameRequest',
    'client',
    'Renames a client.',
  ),
  clientDisconnect: withPayload(
    '/services/ubii/client_disconnect',
    'clientDisconnectRequest',
    'success',
    'Disconnects a client, which stops and shows its user the reason.',
  ),
  clientThrottle: withPayload(
    '/services/ubii/client_throttle',
    'clientThrottleRequest',
    'success',
    'Limits the records that a client publishes per second, or removes this limit.',
  ),
  limitList: withoutPayload(
    '/services/ubii/limit_list',
    'limitList',
    'Lists the limits with their reasons and current use.',
  ),
  settingList: withoutPayload(
    '/services/ubii/setting_list',
    'settingList',
    'Lists the start options of the master, without secrets.',
  ),
  logTail: withPayload(
    '/services/ubii/log_tail',
    'logRequest',
    'logTail',
    'Returns the lines of the log of the master after a cursor.',
  ),
  lanOpen: withoutPayload(
    '/services/ubii/lan_open',
    'success',
    'Opens the master to the local network until it exits.',
  ),
  assetSetList: withoutPayload(
    '/services/ubii/asset_set_list',
    'assetSetList',
    'Lists asset sets, such as models: those of the master, and those it can download.',
  ),
  assetSetDownload: withPayload(
    '/services/ubii/asset_set_download',
    'assetSetRequest',
    'success',
    'Starts the download of an asset set.',
  ),
  assetSetCancel: withPayload(
    '/services/ubii/asset_set_cancel',
    'assetSetRequest',
    'success',
    'Cancels the download of an asset set.',
  ),
  moduleVersionList: withPayload(
    '/services/ubii/module_version_list',
    'moduleVersionRequest',
    'moduleVersionList',
    'Lists the stored versions of a module, or returns one of them.',
  ),
} as const;
