import { withoutPayload, withPayload } from './define-service.ts';

/** Services for those who run a master: who takes what of it, and what is to be done about it. [EX-25] */
export const OPERATION_SERVICES = {
  clientReport: withPayload(
    '/services/ubii/client_report',
    'clientReportRequest',
    'clientReport',
    'Returns what clients do: rates, queues, drops, subscriptions and their share of the work.',
  ),
  clientRename: withPayload(
    '/services/ubii/client_rename',
    'clientRenameRequest',
    'client',
    'Gives a client another name.',
  ),
  clientDisconnect: withPayload(
    '/services/ubii/client_disconnect',
    'clientDisconnectRequest',
    'success',
    'Removes a client, which stops and tells its user why.',
  ),
  clientThrottle: withPayload(
    '/services/ubii/client_throttle',
    'clientThrottleRequest',
    'success',
    'Limits the records a client publishes per second, or lifts that limit.',
  ),
  limitList: withoutPayload(
    '/services/ubii/limit_list',
    'limitList',
    'Lists the limits in force, with their reasons and their present use.',
  ),
  settingList: withoutPayload(
    '/services/ubii/setting_list',
    'settingList',
    'Lists the options the master was started with, without secrets.',
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
    'Lets other machines of the local network reach the master, until it ends.',
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
    'Lists the versions of a module that are kept, or returns one of them.',
  ),
} as const;
