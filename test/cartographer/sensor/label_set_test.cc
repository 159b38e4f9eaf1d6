// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/sensor/label_set.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <string>

#include "absl/strings/str_cat.h"
#include "cartographer/sensor/label_set_check.h"
#include "google/protobuf/text_format.h"

namespace cartographer::sensor {
namespace {

using ::testing::StartsWith;

constexpr char kDeclaration[] = R"pb(
  name: "test"
  default_certainty: 0.9
  classes {
    id: 40
    name: "road"
    color: [ 1, 2, 3 ]
    roles: "ground"
  }
  classes {
    id: 60
    name: "lane"
    color: [ 4, 5, 6 ]
    roles: "ground"
    merged_into: "road"
  }
  classes {
    id: 7
    name: "void"
    color: [ 7, 8, 9 ]
    roles: "unlabeled"
  }
  classes {
    id: 10
    name: "car"
    color: [ 0, 0, 255 ]
    roles: "movable"
    certainty: 0.5
  }
  classes {
    id: 252
    name: "moving-car"
    color: [ 0, 0, 1 ]
    roles: "moving"
    roles: "movable"
  }
  classes {
    id: 0
    name: "unknown"
    color: [ 0, 0, 0 ]
    roles: "unlabeled"
  }
  classes {
    id: 65535
    name: "pole"
    color: [ 9, 9, 9 ]
    roles: "critical"
  }
  classes {
    id: 1
    name: "noise"
    color: [ 9, 9, 9 ]
    merged_into: "unknown"
  }
)pb";

proto::LabelSet Declaration() {
  proto::LabelSet declaration;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(kDeclaration, &declaration));
  return declaration;
}

proto::LabelClass* Class(const std::string& name, proto::LabelSet* declaration) {
  for (proto::LabelClass& label_class : *declaration->mutable_classes()) {
    if (label_class.name() == name) return &label_class;
  }
  ADD_FAILURE() << "no class " << name;
  return declaration->mutable_classes(0);
}

// What Create() says after `edit(class)` has changed the class.
template <typename Edit>
std::string ErrorAfter(const std::string& name, const Edit& edit) {
  proto::LabelSet declaration = Declaration();
  edit(Class(name, &declaration));
  const absl::Status status = LabelSet::Create(declaration).status();
  EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument);
  return std::string(status.message());
}

LabelSet ValidSet() {
  const absl::StatusOr<LabelSet> set = LabelSet::Create(Declaration());
  EXPECT_TRUE(set.ok()) << set.status();
  return *set;
}

TEST(LabelSetTest, NumbersLabelsInTheOrderOfTheDeclaration) {
  const LabelSet set = ValidSet();
  EXPECT_EQ(set.name(), "test");
  EXPECT_EQ(set.size(), 5u);
  EXPECT_EQ(set.Name(kUnlabeled), "void");
  EXPECT_EQ(set.Name(Label{1}), "road");
  EXPECT_EQ(set.Name(Label{2}), "car");
  EXPECT_EQ(set.Name(Label{3}), "moving-car");
  EXPECT_EQ(set.Name(Label{4}), "pole");
  EXPECT_EQ(set.FileId(kUnlabeled), 7);
  EXPECT_EQ(set.FileId(Label{1}), 40);
  EXPECT_EQ(set.FileId(Label{4}), 65535);
  EXPECT_EQ(set.ColorOf(Label{2}).blue, 255);
  EXPECT_EQ(set.ColorOf(kUnlabeled).red, 7);
}

TEST(LabelSetTest, FindsLabelsByFileId) {
  const LabelSet set = ValidSet();
  EXPECT_EQ(set.FromFileId(40), Label{1});
  EXPECT_EQ(set.FromFileId(60), Label{1});
  EXPECT_EQ(set.FromFileId(65535), Label{4});
  for (const uint16_t id : {0, 1, 7}) EXPECT_EQ(set.FromFileId(id), kUnlabeled) << id;
  for (const uint16_t id : {2, 41, 65534}) EXPECT_EQ(set.FromFileId(id), std::nullopt) << id;
  // An id that nobody declares is not listed, be it 0.
  proto::LabelSet without_zero = Declaration();
  Class("unknown", &without_zero)->set_id(5);
  EXPECT_EQ(LabelSet::Create(without_zero)->FromFileId(0), std::nullopt);
}

TEST(LabelSetTest, FindsLabelsByName) {
  const LabelSet set = ValidSet();
  EXPECT_EQ(*set.FromName("pole"), Label{4});
  EXPECT_EQ(*set.FromName("lane"), Label{1});
  EXPECT_EQ(*set.FromName("noise"), kUnlabeled);
  EXPECT_EQ(*set.FromName("unknown"), kUnlabeled);
  EXPECT_EQ(set.FromName("raod").status(),
            absl::NotFoundError("no class \"raod\" in label set \"test\"; did you mean \"road\"?"));
  EXPECT_THAT(std::string(set.FromName("street").status().message()),
              StartsWith("no class \"street\" in label set \"test\"; known: \""));
}

TEST(LabelSetTest, GivesRolesAndCertainties) {
  const LabelSet set = ValidSet();
  EXPECT_TRUE(set.HasRole(kUnlabeled, LabelRole::kUnlabeled));
  EXPECT_TRUE(set.HasRole(Label{1}, LabelRole::kGround));
  EXPECT_TRUE(set.HasRole(Label{2}, LabelRole::kMovable));
  EXPECT_FALSE(set.HasRole(Label{2}, LabelRole::kMoving));
  EXPECT_TRUE(set.HasRole(Label{3}, LabelRole::kMoving));
  EXPECT_TRUE(set.HasRole(Label{3}, LabelRole::kMovable));
  EXPECT_TRUE(set.WithRole(LabelRole::kCritical).Contains(Label{4}));
  EXPECT_FALSE(set.WithRole(LabelRole::kCritical).Contains(Label{1}));
  EXPECT_FLOAT_EQ(set.DefaultCertainty(Label{1}), 0.9f);
  EXPECT_FLOAT_EQ(set.DefaultCertainty(Label{2}), 0.5f);
}

TEST(LabelSetTest, KnowsOnlyUnlabeledByDefault) {
  const LabelSet set;
  EXPECT_EQ(set.size(), 1u);
  EXPECT_EQ(set.name(), "");
  EXPECT_EQ(set.FromFileId(0), kUnlabeled);
  EXPECT_EQ(set.FromFileId(1), std::nullopt);
  EXPECT_EQ(*set.FromName("unlabeled"), kUnlabeled);
  EXPECT_EQ(set.FromName("unlabelled").status().message(),
            "no class \"unlabelled\" in label set \"\"; did you mean \"unlabeled\"?");
  EXPECT_TRUE(set.HasRole(kUnlabeled, LabelRole::kUnlabeled));
}

TEST(LabelSetTest, KeepsItsDeclaration) {
  EXPECT_EQ(ValidSet().declaration().SerializeAsString(), Declaration().SerializeAsString());
}

TEST(LabelSetErrorsTest, NamesMustBeUniqueAndUsableInFlags) {
  EXPECT_EQ(ErrorAfter("pole", [](auto* c) { c->set_name("car"); }),
            "class \"car\": the name is given twice; names must differ");
  for (const std::string name : {"", "a,b", "a b"}) {
    EXPECT_EQ(ErrorAfter("pole", [&](auto* c) { c->set_name(name); }),
              absl::StrCat("class \"", name,
                           "\": a name must not be empty and have no commas or blanks"));
  }
}

TEST(LabelSetErrorsTest, IdsMustBeUniqueAndFit16Bits) {
  EXPECT_EQ(ErrorAfter("pole", [](auto* c) { c->set_id(10); }),
            "class \"pole\": id 10 is that of class \"car\" already; ids must differ");
  for (const int id : {-1, 65536}) {
    EXPECT_EQ(ErrorAfter("pole", [&](auto* c) { c->set_id(id); }),
              absl::StrCat("class \"pole\": id = ", id, "; must satisfy 0 <= x <= 65535"));
  }
}

TEST(LabelSetErrorsTest, ColoursHaveThreeComponentsOfOneByte) {
  EXPECT_EQ(ErrorAfter("pole", [](auto* c) { c->mutable_color()->RemoveLast(); }),
            "class \"pole\": color has 2 components; must have 3: red, green, blue");
  EXPECT_EQ(ErrorAfter("pole", [](auto* c) { c->set_color(1, 256); }),
            "class \"pole\": color has a component of 256; must satisfy 0 <= x <= 255");
  EXPECT_EQ(ErrorAfter("pole", [](auto* c) { c->set_color(2, -1); }),
            "class \"pole\": color has a component of -1; must satisfy 0 <= x <= 255");
}

TEST(LabelSetErrorsTest, CertaintiesAreProbabilities) {
  EXPECT_EQ(ErrorAfter("pole", [](auto* c) { c->set_certainty(1.5); }),
            "class \"pole\": certainty = 1.5; must satisfy 0 <= x <= 1");
  EXPECT_EQ(ErrorAfter("pole", [](auto* c) { c->set_certainty(std::nan("")); }),
            "class \"pole\": certainty = nan; must satisfy 0 <= x <= 1");
  proto::LabelSet declaration = Declaration();
  declaration.set_default_certainty(-0.5);
  EXPECT_EQ(LabelSet::Create(declaration).status().message(),
            "default_certainty = -0.5; must satisfy 0 <= x <= 1");
}

TEST(LabelSetErrorsTest, RolesAreKnownAndUnlabeledStandsAlone) {
  EXPECT_EQ(ErrorAfter("pole", [](auto* c) { c->set_roles(0, "critcal"); }),
            "class \"pole\": unknown role \"critcal\"; did you mean \"critical\"?");
  EXPECT_EQ(ErrorAfter("pole", [](auto* c) { c->add_roles("unlabeled"); }),
            "class \"pole\": the role \"unlabeled\" excludes all others");
}

TEST(LabelSetErrorsTest, MergesLeadToAnUnmergedClassOfTheSameRoles) {
  EXPECT_EQ(ErrorAfter("lane", [](auto* c) { c->set_merged_into("roads"); }),
            "class \"lane\": merged_into = \"roads\" is no class of the set; did you mean "
            "\"road\"?");
  EXPECT_EQ(ErrorAfter("lane", [](auto* c) { c->set_merged_into("lane"); }),
            "class \"lane\": is merged into itself; leave that out");
  EXPECT_EQ(ErrorAfter("noise", [](auto* c) { c->set_merged_into("lane"); }),
            "class \"noise\": merged_into = \"lane\", which is merged itself; name \"road\"");
  EXPECT_EQ(ErrorAfter("moving-car", [](auto* c) { c->set_merged_into("car"); }),
            "class \"moving-car\": has the role \"moving\", which would be lost: \"car\", into "
            "which it is merged, has it not; merge classes of the same roles");
}

TEST(LabelSetErrorsTest, SomeClassIsUnlabeled) {
  proto::LabelSet declaration = Declaration();
  Class("noise", &declaration)->clear_merged_into();
  Class("void", &declaration)->clear_roles();
  Class("unknown", &declaration)->clear_roles();
  EXPECT_EQ(LabelSet::Create(declaration).status().message(),
            "no class has the role \"unlabeled\"; give it to the class of points that nobody "
            "labelled");
  EXPECT_FALSE(LabelSet::Create(proto::LabelSet()).ok());
}

proto::LabelSet DeclarationOfSize(int num_labels) {
  proto::LabelSet declaration;
  for (int i = 0; i <= num_labels; ++i) {
    proto::LabelClass* const label_class = declaration.add_classes();
    label_class->set_id(i);
    label_class->set_name(absl::StrCat("class", i));
    for (int k = 0; k < 3; ++k) label_class->add_color(0);
    if (i == 0) label_class->add_roles("unlabeled");
  }
  return declaration;
}

TEST(LabelSetErrorsTest, LabelsFitOneByte) {
  const absl::StatusOr<LabelSet> set = LabelSet::Create(DeclarationOfSize(255));
  ASSERT_TRUE(set.ok()) << set.status();
  EXPECT_EQ(set->size(), kMaxLabels);
  EXPECT_EQ(*set->FromName("class255"), Label{255});
  proto::LabelSet too_many = DeclarationOfSize(256);
  EXPECT_EQ(LabelSet::Create(too_many).status().message(),
            "256 classes that are neither merged nor unlabeled; there may be 255, so merge some");
  too_many.mutable_classes(256)->set_merged_into("class1");
  EXPECT_TRUE(LabelSet::Create(too_many).ok());
}

TEST(LabelSetErrorsTest, LoadNamesTheFile) {
  const std::string path = ::testing::TempDir() + "/label_set_test.lua";
  std::ofstream(path) << "return { name = 'x', default_certainty = 1, classes = {} }";
  EXPECT_EQ(LabelSet::Load({path, {}}).status().message(),
            path +
                ": no class has the role \"unlabeled\"; give it to the class of points that "
                "nobody labelled");
  std::ofstream(path) << "return { name = 'x', default_certainty = 2, classes = {} }";
  EXPECT_EQ(LabelSet::Load({path, {}}).status().message(),
            path + ": default_certainty = 2; must satisfy 0 <= x <= 1");
  EXPECT_EQ(LabelSet::Load({"/no/such.lua", {}}).status().code(), absl::StatusCode::kNotFound);
}

TEST(LabelSetTest, FromNamesIsWhatItSays) {
  const LabelSet labels = ValidSet();
  google::protobuf::RepeatedPtrField<std::string> names;
  EXPECT_TRUE(labels.FromNames(names)->Empty());
  *names.Add() = "pole";
  *names.Add() = "lane";  // merged into road
  LabelMask expected;
  expected.Insert(*labels.FromName("pole"));
  expected.Insert(*labels.FromName("road"));
  EXPECT_EQ(*labels.FromNames(names), expected);
  *names.Add() = "raod";
  EXPECT_EQ(labels.FromNames(names).status(), labels.FromName("raod").status());
}

TEST(RoleWordTest, NamesEachRole) {
  EXPECT_EQ(RoleWord(LabelRole::kMoving), "moving");
  EXPECT_EQ(RoleWord(LabelRole::kMovable), "movable");
  EXPECT_EQ(RoleWord(LabelRole::kCritical), "critical");
  EXPECT_EQ(RoleWord(LabelRole::kGround), "ground");
  EXPECT_EQ(RoleWord(LabelRole::kUnlabeled), "unlabeled");
}

}  // namespace
}  // namespace cartographer::sensor
