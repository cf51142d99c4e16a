// A scene in an archive: every key of scene_keys.h, bit for bit.
#pragma once

#include "ice_ice_baby/scene_keys.h"

namespace ice_ice_baby {

/// Visitor of describe(): writes or reads what it visits.
template <class Archive>
class SceneArchive {
 public:
  explicit SceneArchive(Archive& archive) : archive_(archive) {}

  template <class Number>
  void operator()(const char*, Number& value, Range, const char*) const {
    archive_(value);
  }
  template <class Word>
  void operator()(const char*, Word& value, const char*) const {
    archive_(value);
  }
  template <class Params>
  void section(const char*, Params& params, const char*) const {
    describe(params, *this);
  }
  template <class Item>
  void list(const char*, std::vector<Item>& items, const char*) const {
    // describe takes a mutable scene, although a writer does not change it.
    archive_.list(items, [&](const Item& item) { describe(const_cast<Item&>(item), *this); });
  }

 private:
  Archive& archive_;
};

/// Visitor of describe(): the names of all keys, in order.
class SceneKeys {
 public:
  template <class Value>
  void operator()(const char* name, Value&, Range, const char*) {
    add(name);
  }
  template <class Value>
  void operator()(const char* name, Value&, const char*) {
    add(name);
  }
  template <class Params>
  void section(const char* name, Params& params, const char*) {
    add(name);
    describe(params, *this);
  }
  template <class Item>
  void list(const char* name, std::vector<Item>&, const char*) {
    Item item;
    section(name, item, "");
  }

  const std::string& names() const { return names_; }

 private:
  void add(const char* name) { names_ += std::string(name) + "\n"; }

  std::string names_;
};

}  // namespace ice_ice_baby
